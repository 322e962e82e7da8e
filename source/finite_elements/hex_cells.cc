// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hex_cells.h"

#include "ricochet/base/exceptions.h"

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
/// Levels below box.edge that the regions ask of a cube.
int levels_wanted(const HexMesh::Box &box, const Vector3 &low, const double edge)
{
  int levels          = 0;
  // Touching is not overlapping: a region drawn on the cubes' faces must not catch their neighbours
  // by rounding.
  const double margin = 1e-6 * edge;
  for (const auto &region : box.regions)
    if ((low.array() < region.high.array() - margin).all() &&
        (low.array() + edge > region.low.array() + margin).all())
      levels = std::max(levels, region.levels);
  return levels;
}

Vector3 as_vector(const dealii::Point<3> &p)
{
  return {p[0], p[1], p[2]};
}
} // namespace

void check_box(const HexMesh::Box &box)
{
  if (box.edge <= 0. || *std::min_element(box.n.begin(), box.n.end()) < 1)
  {
    std::ostringstream message;
    message << "A mesh of " << box.n[0] << " x " << box.n[1] << " x " << box.n[2]
            << " cubes of edge " << 1e3 * box.edge
            << " mm is empty; choose a positive edge and at least one cube along each axis.";
    throw InputError(message.str());
  }
  const Vector3 high = box.corner + box.edge * Vector3(box.n[0], box.n[1], box.n[2]);
  for (const auto &region : box.regions)
    if (region.levels < 1 || (region.low.array() >= region.high.array()).any() ||
        (region.low.array() >= high.array()).any() ||
        (region.high.array() <= box.corner.array()).any())
    {
      std::ostringstream message;
      message << "The refinement region from (" << 1e3 * region.low.transpose() << ") mm to ("
              << 1e3 * region.high.transpose() << ") mm with " << region.levels
              << " levels refines nothing; it must overlap the mesh from ("
              << 1e3 * box.corner.transpose() << ") mm to (" << 1e3 * high.transpose()
              << ") mm, have an extent along each axis and at least one level.";
      throw InputError(message.str());
    }
}

int n_common_halvings(std::array<int, 3> n)
{
  int halvings = 0;
  while (n[0] % 2 == 0 && n[1] % 2 == 0 && n[2] % 2 == 0)
  {
    for (int &count : n)
      count /= 2;
    ++halvings;
  }
  return halvings;
}

void create_cells(Triangulation &triangulation, const HexMesh::Box &box, const int halvings)
{
  std::vector<unsigned int> roots(3);
  std::int64_t n_roots = 1;
  for (int d = 0; d < 3; ++d)
    n_roots *= roots[d] = static_cast<unsigned int>(box.n[d] >> halvings);
  if (n_roots > HexMesh::max_coarse_cells)
  {
    std::ostringstream message;
    message << "The mesh of " << box.n[0] << " x " << box.n[1] << " x " << box.n[2] << " cubes has "
            << n_roots << " roots, more than " << HexMesh::max_coarse_cells
            << "; choose counts along x, y and z that can all be halved more often (multiples of "
            << (2 << halvings) << ").";
    throw InputError(message.str());
  }
  dealii::Point<3> low, high;
  for (int d = 0; d < 3; ++d)
  {
    low[d]  = box.corner[d];
    high[d] = box.corner[d] + box.n[d] * box.edge;
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, roots, low, high);
  triangulation.refine_global(halvings);
  for (;;)
  {
    unsigned int n_flagged = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const int below   = cell->level() - halvings;
        const double edge = std::ldexp(box.edge, -below);
        if (below < levels_wanted(box, as_vector(cell->vertex(0)), edge))
        {
          cell->set_refine_flag();
          ++n_flagged;
        }
      }
    if (dealii::Utilities::MPI::sum(n_flagged, triangulation.get_communicator()) == 0)
      return;
    triangulation.execute_coarsening_and_refinement();
  }
}

void share_cells(Triangulation &triangulation, const HexMesh::Box &box, const int halvings)
{
  if (!box.cost || dealii::Utilities::MPI::n_mpi_processes(triangulation.get_communicator()) == 1)
    return;
  triangulation.signals.weight.connect(
      [&box, halvings](const Triangulation::cell_iterator &cell, const Triangulation::CellStatus)
      {
        const double edge = std::ldexp(box.edge, halvings - cell->level());
        return box.cost(as_vector(cell->vertex(0)) + Vector3::Constant(0.5 * edge), edge);
      });
  triangulation.repartition();
}

std::int64_t checked_number_of_elements(const Triangulation &triangulation)
{
  const auto n = static_cast<std::int64_t>(triangulation.n_global_active_cells());
  if (const int n_ranks = static_cast<int>(
          dealii::Utilities::MPI::n_mpi_processes(triangulation.get_communicator()));
      n < n_ranks)
    throw InputError("A mesh of " + std::to_string(n) + " elements cannot be shared by " +
                     std::to_string(n_ranks) + " ranks; use fewer ranks or smaller elements.");
  return n;
}
} // namespace ricochet
