// SPDX-License-Identifier: LGPL-2.1-or-later
// Viscoplastic flow of one peridynamic body (materials/flow_law.h).
//
// Of the extension of each bond a part e_p is plastic: the energy of a linear peridynamic solid has
// e - e_p where e stands in its bond part, and theta, which stays elastic, of all of e (state-based
// plasticity: Mitchell 2011, SAND2011-3166, here with one e_p per bond, of both its ends). With
//   u = tension / (30 mu omega V^2/m)
// of the bonds that carry - intact ones, and closed cracks, whose law is their own - a point has
//   theta_u = (3/m) sum omega |xi| u V,   p = -(5 mu/3) theta_u,
//   M = theta_u / [(3/m) sum_carrying omega |xi|^2 V],   u_dev = u - |xi| M,
//   tau^2 = 2 mu W_dev,   W_dev = (15 mu/2m) sum omega u_dev^2 V,
// p, tau being pressure and sqrt(J_2) in a homogeneous deformation of the bulk. Where tau exceeds
// what the flow law allows, u_dev shrinks by the share relaxed_by_flow() in one step: e_p of a bond
// moves by the mean of what its two ends take, their own share times their own u_dev. Shares are
// those of the stresses one step ago, so that one sweep does both, lets bonds flow and sums up what
// they carry then.
//
// The mean M is that over bonds which carry: two lonely fragments that meet feel pressure, not
// shear, and do not sink into each other. Points that share their energy with finite elements do
// not yield, and neither do the elements.
#pragma once

#include "ricochet/materials/flow_law.h"
#include "ricochet/peridynamics/bond_blocks.h"
#include "ricochet/peridynamics/bond_history.h"
#include "ricochet/peridynamics/halo.h"
#include "ricochet/peridynamics/lattice_state.h"

#include <mpi.h>
#include <vector>

namespace ricochet
{
class PlaneArchive;
class PlaneExchange;

class BondFlow
{
public:
  /// Nothing has flowed; sets `arrays`' pointers. Lattice and state's arrays must outlive this
  /// object. `family` of the bulk.
  BondFlow(const Lattice &lattice, LatticeArrays &arrays, const FamilyConstants &family,
           const FlowLaw &law, double dt);

  /// Before theta is computed, which counts the strained bonds.
  void begin(const LatticeState &state);
  /// One step, once theta is complete. `blocks` and `halo` of the lattice. Collective.
  void step(const LatticeKernel &kernel, const BondTable &table, const LatticeState &state,
            const BondBlocks &blocks, Halo &halo);

  /// e_p of a bond, kept at `point` [m].
  double plastic_extension(const std::ptrdiff_t point, const std::size_t offset) const
  {
    return plastic_.read(point, offset, 0);
  }
  /// Turned into heat so far [J]. Collective.
  double dissipated(MPI_Comm communicator) const;

  /// The lattice's planes are moving to other ranks: takes over what belongs to them. `arrays`: of
  /// the new share.
  void redistribute(const PlaneExchange &planes, std::ptrdiff_t size, LatticeArrays &arrays);

  /// Saves or restores what has flowed. Collective.
  void exchange_state(PlaneArchive &planes);

private:
  void point_at_fields(LatticeArrays &arrays);
  void mark_blocks();
  std::vector<Lattice::BlockRange> marked(const std::vector<Lattice::BlockRange> &ranges);
  void mark(std::ptrdiff_t point);
  void find_shares(const LatticeState &state, Halo &halo);

  const Lattice &lattice_;
  FamilyConstants family_;
  FlowLaw law_;
  double dt_; // [s]
  BondHistory plastic_;
  std::vector<std::int64_t> reaching_; // blocks that keep bonds of a block's points, relative to it
  std::vector<std::uint8_t> flowed_, marked_;                                // per block
  std::vector<double> strained_, relaxing_, mean_, carrying_, sum_, square_; // see FlowingBonds
  std::vector<double> dissipated_;
};
} // namespace ricochet
