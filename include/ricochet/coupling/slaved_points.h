// SPDX-License-Identifier: LGPL-2.1-or-later
// Peridynamic points that follow the nodes of the element they lie in: x_p = sum N_a(X_p) x_a. What
// pulls at them pulls at the nodes: f_a += N_a(X_p) f_p, the transpose, so that the power of the
// forces is the same on both sides. Each element of the zone's cell size holds n x n x n points,
// the centres of its sub-cubes, n = 1, 2 or 4. Lattice and mesh are shared among the ranks in
// different ways; what a rank needs of the other's comes by finite_elements/node_links.h.
#pragma once

#include "ricochet/finite_elements/finite_element_body.h"
#include "ricochet/finite_elements/node_links.h"
#include "ricochet/peridynamics/peridynamic_body.h"

#include <functional>

namespace ricochet
{
/// The cell of the lattice's zone in which a position of the reference configuration lies.
Zone::Cell cell_at(const Lattice &lattice, const Vector3 &position);

class SlavedPoints
{
public:
  SlavedPoints() = default;
  /// The points of the cells for which `is_slaved` is true; their elements must exist in cell size.
  /// Collective.
  SlavedPoints(MPI_Comm communicator, const FiniteElementBody &elements, const Lattice &lattice,
               const std::function<bool(const Zone::Cell &)> &is_slaved);

  /// Points take over position and velocity. Collective.
  void interpolate_to_slaved_points(const FiniteElementBody &elements, LatticeState &state);
  /// Points take over any nodal field, three numbers per node. Collective.
  void interpolate(const std::vector<double> &nodal, double *const field[3]);
  /// Forces of the points are added to those of the nodes. Collective.
  void add_transposed(const LatticeState &state, std::vector<double> &nodal_force);

private:
  struct Cell
  {
    std::ptrdiff_t first;    // point with the lowest coordinates
    std::array<int, 8> node; // in the order of links_; corners x + 2 y + 4 z
  };

  /// Calls visit(p, i) for the points of a cell; i counts along x first, then y, z.
  template <int n, class Visitor>
  void for_each_point(const Cell &cell, Visitor &&visit) const
  {
    for (int z = 0, i = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x, ++i)
          visit(cell.first + x * stride_[0] + y * stride_[1] + z * stride_[2], i);
  }
  template <int n>
  void interpolate_cells(double *const field[3]) const;
  template <int n>
  void collect_forces(const LatticeState &state);

  int points_per_edge_ = Zone::usual_points_per_edge;
  std::array<std::ptrdiff_t, 3> stride_{}; // between points along x, y, z
  std::vector<Cell> cells_;
  NodeLinks links_;
  std::vector<double> values_, beyond_; // per linked node, workspace
};
} // namespace ricochet
