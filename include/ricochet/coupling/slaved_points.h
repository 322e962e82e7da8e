// SPDX-License-Identifier: LGPL-2.1-or-later
// Peridynamic points that follow the nodes of the element they lie in: x_p = sum N_a(X_p) x_a. What
// pulls at them pulls at the nodes: f_a += N_a(X_p) f_p, the transpose, so that the power of the
// forces is the same on both sides. Each element of the zone's cell size holds 2 x 2 x 2 points,
// the centres of its sub-cubes. Lattice and mesh are shared among the ranks in different ways; what
// a rank needs of the other's comes by discretization/node_links.h.
#pragma once

#include "ricochet/discretization/node_links.h"
#include "ricochet/forces/finite_element_force.h"
#include "ricochet/forces/peridynamic_force.h"

#include <functional>

namespace ricochet
{
/// The cell of the zone in which a position of the reference configuration lies.
Zone::Cell cell_at(const Lattice::Box &box, const Vector3 &position);

class SlavedPoints
{
public:
  SlavedPoints() = default;
  /// The points of the cells for which `follows` is true; their elements must exist in cell size.
  /// Collective.
  SlavedPoints(MPI_Comm communicator, const FiniteElementForce &elements, const Lattice &lattice,
               const std::function<bool(const Zone::Cell &)> &follows);

  /// Points take over position and velocity. Collective.
  void follow(const FiniteElementForce &elements, LatticeState &state);
  /// Points take over any nodal field, three numbers per node. Collective.
  void interpolate(const std::vector<double> &nodal, double *const field[3]);
  /// Forces of the points are added to those of the nodes. Collective.
  void hand_on(const LatticeState &state, std::vector<double> &nodal_force);

private:
  struct Cell
  {
    std::ptrdiff_t first;    // point with the lowest coordinates
    std::array<int, 8> node; // in the order of links_; corners x + 2 y + 4 z
  };

  std::ptrdiff_t point(const Cell &cell, const int corner) const
  {
    return cell.first + (corner & 1) * stride_[0] + ((corner >> 1) & 1) * stride_[1] +
           (corner >> 2) * stride_[2];
  }

  std::array<std::ptrdiff_t, 3> stride_{}; // between points along x, y, z
  std::vector<Cell> cells_;
  NodeLinks links_;
  std::vector<double> values_; // per linked node, workspace
};
} // namespace ricochet
