// SPDX-License-Identifier: LGPL-2.1-or-later
// The mass of chosen elements as if it sat in the centres of their sub-cubes, n along an edge, and
// not in their corners: a consistent mass matrix M_C instead of the lumped one, M_L. It is applied
// to first order, a = M_L^-1 (f + (M_L - M_C) M_L^-1 f), which needs no solution in a time step and
// leaves the sum of all forces as it is, because the rows of both matrices have the same sums.
//
// The mass that the motion then has is M_eff = M_L (2 M_L - M_C)^-1 M_L to be exact, and M_eff v
// the momentum that forces add up to; it is carried along with the velocity.
#pragma once

#include "ricochet/base/state_archive.h"
#include "ricochet/finite_elements/lumped_mass.h"

#include <mpi.h>

namespace ricochet
{
class ConsistentMass
{
public:
  /// `elements`: of this rank, numbers in mesh.elements(). Mesh and lumped mass must outlive this
  /// object. Collective.
  ConsistentMass(MPI_Comm communicator, const HexMesh &mesh, const LumpedMass &lumped,
                 double density, const std::vector<int> &elements, int points_per_edge);

  /// The momentum that belongs to these velocities (three numbers per local node, of which those of
  /// owned nodes count). Throws RunError if it is not found. Collective.
  void find_momentum(const std::vector<double> &velocity);

  /// Forces on owned nodes f become f + (M_L - M_C) M_L^-1 f; entries of ghosts must be zero [N].
  /// Collective.
  void correct(std::vector<double> &force);

  /// The forces before the last correct() act for a time `kick` [s].
  void advance(double kick);

  /// Owned corners of the elements, ascending.
  const std::vector<int> &nodes() const { return nodes_; }
  // Three numbers per entry of nodes().
  const std::vector<double> &momentum() const { return momentum_; }                   // [kg m/s]
  const std::vector<double> &uncorrected_force() const { return uncorrected_force_; } // [N]

  /// Adds (M_L - M_C) a of this rank's elements, three numbers per local node.
  void add_mass_difference(const std::vector<double> &acceleration,
                           std::vector<double> &force) const;

  /// Saves or restores the momentum. Collective.
  void exchange_state(StateArchive &archive);

  /// All eigenvalues of M_L^-1 (2 M_L - M_C) lie between these: an edge's consistent mass has
  /// eigenvalues between 0 and 1 times those of its lumped mass, hence so have a cube's, their
  /// products, and a mesh's, of cubes.
  static constexpr double smallest_eigenvalue = 1., largest_eigenvalue = 2.;

private:
  void multiply(std::vector<double> &x, std::vector<double> &result) const;
  double squared_norm(const std::vector<double> &residual) const;

  MPI_Comm communicator_;
  const HexMesh &mesh_;
  const LumpedMass &lumped_;
  double density_; // [kg/m^3]
  std::vector<int> elements_;
  double near_, far_; // an edge's mass couples an end to itself and to the other [-]
  std::vector<int> nodes_;
  std::vector<double> uncorrected_force_, momentum_;
  std::vector<double> acceleration_; // workspace
};
} // namespace ricochet
