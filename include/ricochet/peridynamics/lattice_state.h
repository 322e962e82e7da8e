// SPDX-License-Identifier: LGPL-2.1-or-later
// All that moves on a lattice: positions, velocities, forces, dilatation (theta of the state-based
// theory, Silling et al. 2007), bonds.
//
// A field is one array of Lattice::size() numbers, padding included, indexed by the flat point
// index; vectors are three fields. Bonds are bits: Lattice::size()/8 * n_offsets bytes,
// [block][offset], bit l being the bond from point 8 block + l (Silling and Askari 2005: a bond
// that has broken never heals); so are the broken ones that still push. Entries where no point
// exists are zero, but for positions. Units stand at LatticeArrays.
#pragma once

#include "ricochet/kernels/lattice_kernel.h"
#include "ricochet/peridynamics/lattice.h"

#include <memory>

namespace ricochet
{
class PlaneArchive;
class PlaneExchange;

class LatticeState
{
public:
  /// At rest in the reference configuration, all bonds intact. With a zone there are weights, too.
  /// `cracks_push`: whether broken bonds may. Throws std::bad_alloc.
  explicit LatticeState(const Lattice &lattice, bool cracks_push = false);

  LatticeArrays arrays; // into the storage below

  /// Owned points at rest in the reference configuration, without forces; ghosts and images stay.
  void rest(const Lattice &lattice);

  /// One of arrays' fields, where points exist.
  void zero(const Lattice &lattice, double *field) const;

  /// After the lattice has followed its zone: points of the planes first <= x < last (global) take
  /// their weight.
  void follow_zone(const Lattice &lattice, int first, int last);
  /// Multiplies the weight of each point that exists by `factor` [-], Lattice::size() numbers.
  /// Needs a zone.
  void scale_weights(const Lattice &lattice, const std::vector<double> &factor);
  /// Multiplies a field of owned points by their weight w [-]; without a zone w is 1.
  void weigh(const Lattice &lattice, double *field) const;

  /// The planes of a state just made, with `lattice` as its share, take over from the state before:
  /// motion, dilatation of the step before and bonds, ghosts too. Collective.
  void take_over(const LatticeState &before, const PlaneExchange &planes, const Lattice &lattice);

  /// Saves or restores motion, dilatation of the step before and bonds; forces and what follows
  /// from the others are left alone. Collective.
  void exchange_state(PlaneArchive &planes, const Lattice &lattice);

  /// Images across y = 0 take over position and velocity, a scalar, or the components 11, 22, 33,
  /// 23, 13, 12 of a symmetric tensor, of their originals.
  void mirror_motion(const Lattice &lattice);
  /// See mirror_motion().
  void mirror(const Lattice &lattice, double *scalar) const;
  /// See mirror_motion().
  void mirror_component(const Lattice &lattice, double *field, int component) const;

private:
  struct Free
  {
    void operator()(double *p) const;
  };
  void set_weights(const Lattice &lattice, std::ptrdiff_t first, std::ptrdiff_t last);

  std::ptrdiff_t size_;
  std::unique_ptr<double[], Free> storage_;
  std::vector<std::uint8_t> bonds_, cracked_;
};
} // namespace ricochet
