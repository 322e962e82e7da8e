// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/zone.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// Every cell takes the largest value of its neighbours, diagonal ones included: one axis after the
/// other.
void dilate(std::vector<char> &cells, const std::array<int, 3> &n)
{
  const std::array<std::ptrdiff_t, 3> stride{std::ptrdiff_t(n[1]) * n[2], n[2], 1};
  std::vector<char> before;
  for (int axis = 0; axis < 3; ++axis)
  {
    before              = cells;
    const auto extent   = n[axis];
    const auto s        = stride[axis];
    const auto n_in_all = static_cast<std::ptrdiff_t>(cells.size());
    for (std::ptrdiff_t c = 0; c < n_in_all; ++c)
    {
      const auto at = (c / s) % extent;
      if (at > 0)
        cells[c] |= before[c - s];
      if (at + 1 < extent)
        cells[c] |= before[c + s];
    }
  }
}
Zone::Cells common(Zone::Cells a, const Zone::Cells &b)
{
  for (int d = 0; d < 3; ++d)
  {
    a.low[d]  = std::max(a.low[d], b.low[d]);
    a.high[d] = std::min(a.high[d], b.high[d]);
  }
  return a;
}
} // namespace

double blend(const BlendFunction function, const double t)
{
  if (t <= 0. || t >= 1. || function == BlendFunction::step)
    return t < 1. ? 1. : 0.;
  return function == BlendFunction::linear ? 1. - t : 1. - t * t * (3. - 2. * t);
}

Zone::Zone(const std::array<int, 3> &n_cells, const int reach, const BlendFunction blend,
           const int blend_layers, const int points_per_edge) :
  n_(n_cells),
  limit_{{0, 0, 0}, n_cells}, points_per_edge_(points_per_edge),
  // A free point feels the dilatation of its neighbours, so these need all of theirs.
  pad_(std::max((reach + points_per_edge - 1) / points_per_edge, blend_layers)),
  halo_((reach + points_per_edge - 1) / points_per_edge), blend_(blend),
  layers_(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2], static_cast<std::uint8_t>(far())),
  contact_(layers_.size(), 0)
{
}

/// The cells of a box that lie in the plate.
template <class Visitor>
void Zone::for_each_cell_in(const Cells &box, Visitor &&visit) const
{
  for (int i = std::max(0, box.low[0]); i < std::min(n_[0], box.high[0]); ++i)
    for (int j = std::max(0, box.low[1]); j < std::min(n_[1], box.high[1]); ++j)
      for (int k = std::max(0, box.low[2]); k < std::min(n_[2], box.high[2]); ++k)
        visit(number({i, j, k}));
}

bool Zone::would_grow(const std::vector<Cells> &boxes) const
{
  bool changes = false;
  for (const auto &box : boxes)
    for_each_cell_in(common(box, limit_),
                     [&](const std::size_t c) { changes = changes || layers_[c] != 0; });
  return changes;
}

bool Zone::grow(const std::vector<Cells> &boxes)
{
  if (!would_grow(boxes))
    return false;
  for (const auto &box : boxes)
    for_each_cell_in(common(box, limit_), [&](const std::size_t c) { layers_[c] = 0; });
  find_layers();
  return true;
}

std::array<int, 2> Zone::rows() const
{
  int low = limit_.low[1] - slaved_layers(), high = limit_.high[1] + slaved_layers();
  for_each_cell(
      [&](const Cell &cell)
      {
        if (contact_[number(cell)] || layer(cell) < far())
        {
          low  = std::min(low, cell[1]);
          high = std::max(high, cell[1] + 1);
        }
      });
  return {points_per_edge_ * std::max(0, low), points_per_edge_ * std::min(n_[1], high)};
}

std::vector<char> Zone::interface_band(const int width) const
{
  std::vector<char> near(layers_.size());
  for (std::size_t c = 0; c < layers_.size(); ++c)
    near[c] = layers_[c] != 0;
  for (int i = 0; i < width; ++i)
    dilate(near, n_);
  for (std::size_t c = 0; c < layers_.size(); ++c)
    near[c] = near[c] && layers_[c] == 0;
  return near;
}

void Zone::set_contact_region(const std::vector<Cells> &boxes)
{
  std::fill(contact_.begin(), contact_.end(), 0);
  for (const auto &box : boxes)
    for_each_cell_in(box, [&](const std::size_t c) { contact_[c] = 1; });
  for_each_cell(
      [&](const Cell &cell)
      {
        // y = 0 may be a symmetry plane; contact points there do no harm.
        bool surface = false;
        for (int d = 0; d < 3; ++d)
          surface = surface || cell[d] == 0 || cell[d] == n_[d] - 1;
        contact_[number(cell)] = contact_[number(cell)] && surface;
      });
}

void Zone::find_layers()
{
  std::vector<char> reached(layers_.size());
  for (std::size_t c = 0; c < layers_.size(); ++c)
    reached[c] = layers_[c] == 0;
  for (std::size_t c = 0; c < layers_.size(); ++c)
    if (!reached[c])
      layers_[c] = static_cast<std::uint8_t>(far());
  for (int layer = 1; layer < far(); ++layer)
  {
    dilate(reached, n_);
    for (std::size_t c = 0; c < layers_.size(); ++c)
      if (reached[c] && layers_[c] == far())
        layers_[c] = static_cast<std::uint8_t>(layer);
  }
}

double Zone::weight(const int x, const int y, const int z) const
{
  const Cell cell = cell_of(x, y, z);
  const int layer = this->layer(cell);
  if (layer == 0)
    return 1.;
  if (layer > pad_)
    return 0.;
  if (blend_ == BlendFunction::step)
    return 1.;

  // Distance from the zone in points: to the nearest cell of the layer before, and from there on.
  const int n     = points_per_edge_;
  const int at[3] = {x % n, y % n, z % n};
  int nearest     = n;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
      {
        const int side[3] = {i, j, k};
        Cell other        = cell;
        int apart         = 1;
        for (int d = 0; d < 3; ++d)
        {
          other[d] += side[d];
          apart = std::max(apart, side[d] < 0 ? at[d] + 1 : side[d] > 0 ? n - at[d] : 1);
        }
        if (contains(other) && this->layer(other) == layer - 1)
          nearest = std::min(nearest, apart);
      }
  const int distance = n * (layer - 1) + nearest;
  const double t     = (distance - 0.5) / (n * pad_);
  return blend(blend_, t);
}

std::int64_t Zone::n_free_cells() const
{
  return std::count(layers_.begin(), layers_.end(), 0);
}

std::int64_t Zone::n_slaved_cells() const
{
  return std::count_if(layers_.begin(), layers_.end(),
                       [&](const std::uint8_t layer) { return layer > 0 && layer < far(); });
}

std::vector<Zone::Cells> Zone::free_cells() const
{
  std::vector<Cells> cells;
  for_each_cell(
      [&](const Cell &cell)
      {
        if (is_free(cell))
          cells.push_back({cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}});
      });
  return cells;
}
} // namespace ricochet
