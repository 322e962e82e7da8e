// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/slaved_points.h"

#include "ricochet/discretization/exchange.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ricochet
{
namespace
{
// Shape functions along an edge at the centres of its halves.
constexpr double near = 0.75, far = 0.25;

/// Between the values at the corners and those at the sub-cubes' centres; the matrix is symmetric,
/// so it is its own transpose. Three components per corner.
inline void blend_along_axes(double (&v)[8][3])
{
  for (const int axis : {1, 2, 4})
    for (int corner = 0; corner < 8; ++corner)
      if ((corner & axis) == 0)
        for (int d = 0; d < 3; ++d)
        {
          const double low = v[corner][d], high = v[corner | axis][d];
          v[corner][d]        = near * low + far * high;
          v[corner | axis][d] = far * low + near * high;
        }
}

struct SentCell
{
  Zone::Cell cell;
  std::int64_t node[8]; // global numbers
};
} // namespace

Zone::Cell cell_at(const Lattice::Box &box, const Vector3 &position)
{
  const Vector3 at = (position - box.corner) / (Zone::points_per_edge * box.spacing);
  return {static_cast<int>(std::floor(at[0])), static_cast<int>(std::floor(at[1])),
          static_cast<int>(std::floor(at[2]))};
}

SlavedPoints::SlavedPoints(const MPI_Comm communicator, const FiniteElementForce &elements,
                           const Lattice &lattice,
                           const std::function<bool(const Zone::Cell &)> &follows) :
  stride_{lattice.plane_stride(), 1, lattice.row_stride()}
{
  const auto &mesh   = elements.mesh();
  const auto &box    = lattice.box();
  const double edge  = Zone::points_per_edge * box.spacing;
  const auto &starts = lattice.plane_starts();
  std::vector<std::vector<SentCell>> sent(starts.size() - 1);
  for (const auto &element : mesh.elements())
  {
    if (std::abs(element.edge - edge) > 0.1 * edge)
      continue;
    SentCell one{cell_at(box, mesh.centre(element)), {}};
    if (!follows(one.cell))
      continue;
    for (int corner = 0; corner < 8; ++corner)
      one.node[corner] = mesh.global_node(element.nodes[corner]);
    const int plane = Zone::points_per_edge * one.cell[0];
    const auto rank = std::upper_bound(starts.begin(), starts.end(), plane) - starts.begin() - 1;
    sent[rank].push_back(one);
  }
  auto received = joined(exchange_lists(communicator, sent));
  // In the order of the points, whatever the number of ranks.
  std::sort(received.begin(), received.end(),
            [](const SentCell &a, const SentCell &b) {
              return std::tie(a.cell[0], a.cell[2], a.cell[1]) <
                     std::tie(b.cell[0], b.cell[2], b.cell[1]);
            });

  std::vector<std::int64_t> nodes;
  for (const auto &cell : received)
    nodes.insert(nodes.end(), cell.node, cell.node + 8);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const auto &one : received)
  {
    constexpr int n = Zone::points_per_edge;
    Cell cell{lattice.index(n * one.cell[0], n * one.cell[1], n * one.cell[2]), {}};
    for (int corner = 0; corner < 8; ++corner)
      cell.node[corner] = static_cast<int>(
          std::lower_bound(nodes.begin(), nodes.end(), one.node[corner]) - nodes.begin());
    cells_.push_back(cell);
  }
  links_ = NodeLinks(communicator, mesh, nodes);
  values_.resize(3 * nodes.size());
}

void SlavedPoints::interpolate(const std::vector<double> &nodal, double *const field[3])
{
  links_.fetch(nodal, values_);
  for (const auto &cell : cells_)
  {
    double v[8][3];
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        v[corner][d] = values_[3 * cell.node[corner] + d];
    blend_along_axes(v);
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        field[d][point(cell, corner)] = v[corner][d];
  }
}

void SlavedPoints::follow(const FiniteElementForce &elements, LatticeState &state)
{
  interpolate(elements.position(), state.arrays.position);
  interpolate(elements.velocity(), state.arrays.velocity);
}

void SlavedPoints::hand_on(const LatticeState &state, std::vector<double> &nodal_force)
{
  std::fill(values_.begin(), values_.end(), 0.);
  for (const auto &cell : cells_)
  {
    double v[8][3];
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        v[corner][d] = state.arrays.force[d][point(cell, corner)];
    blend_along_axes(v);
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        values_[3 * cell.node[corner] + d] += v[corner][d];
  }
  links_.add(values_, nodal_force);
}
} // namespace ricochet
