// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/slaved_points.h"

#include "ricochet/base/exchange.h"
#include "ricochet/base/phase_clock.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ricochet
{
namespace
{
/// The shape functions of the two ends of an edge at the centres of its n parts.
template <int n>
struct EdgeShapes
{
  double at[n][2];

  constexpr EdgeShapes() : at{}
  {
    for (int i = 0; i < n; ++i)
    {
      at[i][1] = (i + 0.5) / n;
      at[i][0] = 1. - at[i][1];
    }
  }
};

/// One axis of a product of shape functions: values of `inner` numbers at the two ends become such
/// at n points, or sums back to the ends; `outer` times.
template <int n, int outer, int inner>
inline void interpolate_axis(const double *const ends, double *const points)
{
  constexpr EdgeShapes<n> shapes;
  for (int o = 0; o < outer; ++o)
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < inner; ++k)
        points[(o * n + i) * inner + k] = shapes.at[i][0] * ends[2 * o * inner + k] +
                                          shapes.at[i][1] * ends[(2 * o + 1) * inner + k];
}
template <int n, int outer, int inner>
inline void collect_axis(const double *const points, double *const ends)
{
  constexpr EdgeShapes<n> shapes;
  for (int o = 0; o < outer; ++o)
    for (int end = 0; end < 2; ++end)
      for (int k = 0; k < inner; ++k)
      {
        double sum = shapes.at[0][end] * points[o * n * inner + k];
        for (int i = 1; i < n; ++i)
          sum += shapes.at[i][end] * points[(o * n + i) * inner + k];
        ends[(2 * o + end) * inner + k] = sum;
      }
}

struct SentCell
{
  Zone::Cell cell;
  std::int64_t node[8]; // global numbers
};
} // namespace

Zone::Cell cell_at(const Lattice &lattice, const Vector3 &position)
{
  const auto &box  = lattice.box();
  const Vector3 at = (position - box.corner) / (lattice.zone()->points_per_edge() * box.spacing);
  return {static_cast<int>(std::floor(at[0])), static_cast<int>(std::floor(at[1])),
          static_cast<int>(std::floor(at[2]))};
}

SlavedPoints::SlavedPoints(const MPI_Comm communicator, const FiniteElementBody &elements,
                           const Lattice &lattice,
                           const std::function<bool(const Zone::Cell &)> &is_slaved) :
  points_per_edge_(lattice.zone()->points_per_edge()),
  stride_{lattice.plane_stride(), 1, lattice.row_stride()}
{
  const auto &mesh   = elements.mesh();
  const double edge  = points_per_edge_ * lattice.box().spacing;
  const auto &starts = lattice.plane_starts();
  std::vector<std::vector<SentCell>> sent(starts.size() - 1);
  for (const auto &element : mesh.elements())
  {
    if (std::abs(element.edge - edge) > 0.1 * edge)
      continue;
    SentCell one{cell_at(lattice, mesh.centre(element)), {}};
    if (!is_slaved(one.cell))
      continue;
    for (int corner = 0; corner < 8; ++corner)
      one.node[corner] = mesh.global_node(element.nodes[corner]);
    const int plane = points_per_edge_ * one.cell[0];
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
    const int n = points_per_edge_;
    Cell cell{lattice.index(n * one.cell[0], n * one.cell[1], n * one.cell[2]), {}};
    for (int corner = 0; corner < 8; ++corner)
      cell.node[corner] = static_cast<int>(
          std::lower_bound(nodes.begin(), nodes.end(), one.node[corner]) - nodes.begin());
    cells_.push_back(cell);
  }
  links_ = NodeLinks(communicator, mesh, nodes);
  values_.resize(3 * nodes.size());
}

template <int n>
void SlavedPoints::interpolate_cells(double *const field[3]) const
{
  for (const auto &cell : cells_)
  {
    double corners[8 * 3], x[4 * n * 3], y[2 * n * n * 3], v[n * n * n * 3];
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        corners[3 * corner + d] = values_[3 * cell.node[corner] + d];
    interpolate_axis<n, 4, 3>(corners, x);
    interpolate_axis<n, 2, 3 * n>(x, y);
    interpolate_axis<n, 1, 3 * n * n>(y, v);
    for_each_point<n>(cell,
                      [&](const std::ptrdiff_t p, const int i)
                      {
                        for (int d = 0; d < 3; ++d)
                          field[d][p] = v[3 * i + d];
                      });
  }
}

template <int n>
void SlavedPoints::collect_forces(const LatticeState &state)
{
  // Apart by the side of the node on which the cell lies, along x: each side is one layer of cells
  // and lies on one rank, and two numbers can be added in one way only.
  std::fill(values_.begin(), values_.end(), 0.);
  beyond_.assign(values_.size(), 0.);
  for (const auto &cell : cells_)
  {
    double v[n * n * n * 3], x[2 * n * n * 3], y[4 * n * 3], corners[8 * 3];
    for_each_point<n>(cell,
                      [&](const std::ptrdiff_t p, const int i)
                      {
                        for (int d = 0; d < 3; ++d)
                          v[3 * i + d] = state.arrays.force[d][p];
                      });
    collect_axis<n, n * n, 3>(v, x);
    collect_axis<n, n, 2 * 3>(x, y);
    collect_axis<n, 1, 4 * 3>(y, corners);
    for (int corner = 0; corner < 8; ++corner)
      for (int d = 0; d < 3; ++d)
        ((corner & 1) != 0 ? values_ : beyond_)[3 * cell.node[corner] + d] +=
            corners[3 * corner + d];
  }
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] += beyond_[i];
}

void SlavedPoints::interpolate(const std::vector<double> &nodal, double *const field[3])
{
  links_.fetch(nodal, values_);
  switch (points_per_edge_)
  {
    case 1:
      return interpolate_cells<1>(field);
    case 2:
      return interpolate_cells<2>(field);
    default:
      return interpolate_cells<4>(field);
  }
}

void SlavedPoints::interpolate_to_slaved_points(const FiniteElementBody &elements,
                                                LatticeState &state)
{
  const PhaseClock::Work work(Phase::elements);
  interpolate(elements.position(), state.arrays.position);
  interpolate(elements.velocity(), state.arrays.velocity);
}

void SlavedPoints::add_transposed(const LatticeState &state, std::vector<double> &nodal_force)
{
  const PhaseClock::Work work(Phase::elements);
  switch (points_per_edge_)
  {
    case 1:
      collect_forces<1>(state);
      break;
    case 2:
      collect_forces<2>(state);
      break;
    default:
      collect_forces<4>(state);
  }
  links_.add(values_, nodal_force);
}
} // namespace ricochet
