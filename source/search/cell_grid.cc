// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cell_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
// Images are numbered by ten bits per axis, with room for the step to a neighbour.
constexpr int image_bits           = 10;
constexpr std::int64_t first_image = 4, last_image = (1 << image_bits) - 5;
constexpr std::int32_t no_image = -1;

constexpr double farthest = 1e12; // [cells]: above, coordinates in cells would be too coarse
} // namespace

CellGrid::CellGrid(const std::vector<Vector3> &points, const std::vector<char> &active,
                   const double radius) :
  radius_(radius),
  // Two points a radius apart are in neighbouring cells even after rounding.
  size_(radius * (1. + 1e-3)), position_(points.empty() ? nullptr : points[0].data())
{
  assert(radius > 0. && points.size() < std::size_t(std::numeric_limits<std::int32_t>::max()));
  assert(active.empty() || active.size() == points.size());
  choose_cells(points);

  std::vector<Place> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places[i] = place(points[i]);
  if (!active.empty() && std::find(active.begin(), active.end(), 0) != active.end())
  {
    const std::vector<char> near = cells_near(places, active);
    for (auto &place : places)
      if (place.cell >= 0 && !near[place.cell])
        place.cell = -1;
    sort(places, active);
  }
  else
    sort(places, {});
}

void CellGrid::choose_cells(const std::vector<Vector3> &points)
{
  low_         = Vector3::Constant(std::numeric_limits<double>::max());
  Vector3 high = -low_;
  for (const auto &x : points)
    if (x.allFinite())
    {
      low_ = low_.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  if (low_.x() > high.x())
    low_ = high = Vector3::Zero();
  const double reach = (high - low_).maxCoeff();
  size_              = std::max(size_, reach / farthest);
  extent_            = reach / size_;

  // An axis that does not wrap has one empty layer, so that neighbours need no test for the end.
  const std::int64_t most =
      std::max<std::int64_t>(64, 4 * static_cast<std::int64_t>(points.size()));
  std::array<std::int64_t, 3> n{};
  for (int d = 0; d < 3; ++d)
    n[d] = static_cast<std::int64_t>((high[d] - low_[d]) / size_) + 2;
  const auto too_many = [&] { return double(n[0]) * double(n[1]) * double(n[2]) > double(most); };
  while (too_many())
  {
    const auto d = std::max_element(n.begin(), n.end()) - n.begin();
    int log2     = 2; // with four cells the neighbours on either side are different ones
    while ((std::int64_t(2) << log2) < n[d])
      ++log2;
    if (std::int64_t(1) << log2 >= n[d])
      break; // 4 x 4 x 4
    n[d]      = std::int64_t(1) << log2;
    wraps_[d] = true;
    log2_[d]  = log2;
  }
  for (int d = 0; d < 3; ++d)
    n_[d] = static_cast<std::int32_t>(n[d]);
}

CellGrid::Place CellGrid::place(const Vector3 &x) const
{
  if (!x.allFinite())
    return {-1, no_image, {}};
  Place place;
  std::int64_t c[3], image = 0;
  for (int d = 0; d < 3; ++d)
  {
    const double t = (x[d] - low_[d]) / size_;
    c[d]           = static_cast<std::int64_t>(t); // t >= 0
    double u       = t;
    if (wraps_[d])
    {
      std::int64_t period = c[d] >> log2_[d];
      u -= static_cast<double>(period << log2_[d]);
      c[d] &= n_[d] - 1;
      period += first_image;
      image = image < 0 || period > last_image ? std::int64_t(no_image)
                                               : image + (period << (image_bits * d));
    }
    place.u[d] = static_cast<float>(u);
  }
  place.cell  = static_cast<std::int32_t>((c[0] * n_[1] + c[1]) * n_[2] + c[2]);
  place.image = static_cast<std::int32_t>(image);
  return place;
}

/// The cells with an active point and all their neighbours.
std::vector<char> CellGrid::cells_near(const std::vector<Place> &places,
                                       const std::vector<char> &active) const
{
  const std::int64_t stride[] = {std::int64_t(n_[1]) * n_[2], n_[2], 1};
  const std::int64_t n_cells  = stride[0] * n_[0];
  std::vector<char> near(n_cells, 0), before;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (active[i] && places[i].cell >= 0)
      near[places[i].cell] = 1;
  for (int d = 0; d < 3; ++d)
  {
    before                  = near;
    const std::int64_t step = stride[d], period = step * n_[d];
    for (std::int64_t first = 0; first < n_cells; first += period)
      for (std::int64_t c = 0; c < period; ++c)
      {
        // The last cell and the first one are neighbours.
        const std::int64_t up = c + step < period ? c + step : c + step - period;
        near[first + c] |= before[first + up];
        near[first + up] |= before[first + c];
      }
  }
  return near;
}

void CellGrid::sort(const std::vector<Place> &places, const std::vector<char> &active)
{
  const std::int64_t n_cells = std::int64_t(n_[0]) * n_[1] * n_[2];
  begin_.assign(n_cells + 2, 0);
  for (const auto &place : places)
    if (place.cell >= 0)
      ++begin_[place.cell];
  std::int32_t sum = 0;
  for (auto &begin : begin_)
  {
    sum += begin;
    begin = sum; // the end of the cell, counted down below
  }

  const std::size_t padded = sum + SortedPoints::padding;
  order_.assign(padded, 0);
  image_.assign(padded, no_image);
  active_.assign(active.empty() ? 0 : padded, 0);
  for (auto &u : u_)
    u.assign(padded, 0.f);
  for (std::size_t i = places.size(); i-- > 0;)
    if (places[i].cell >= 0)
    {
      const std::int32_t at = --begin_[places[i].cell];
      order_[at]            = static_cast<std::int32_t>(i);
      image_[at]            = places[i].image;
      if (!active.empty())
        active_[at] = active[i] ? -1 : 0;
      for (int d = 0; d < 3; ++d)
        u_[d][at] = places[i].u[d];
    }
  order_.resize(sum); // the padding behind it stays readable
}

SortedPoints CellGrid::sorted_points() const
{
  // Error of a coordinate in cells: in double precision over the whole extent, in single precision
  // over the grid; of a squared difference, which is about 1, at most 2 sqrt(3) 2 e + 12 e^2 and
  // rounding.
  const double longest = *std::max_element(n_.begin(), n_.end());
  const double e       = std::ldexp(longest, -24) + std::ldexp(extent_, -50);
  const double error   = 8. * e + 16. * e * e + std::ldexp(1., -20);
  const double r       = radius_ / size_;

  SortedPoints p;
  for (int d = 0; d < 3; ++d)
    p.u[d] = u_[d].data();
  p.image          = image_.data();
  p.active         = active_.empty() ? nullptr : active_.data();
  p.number         = order_.data();
  p.position       = position_;
  p.squared_radius = radius_ * radius_;
  p.sure           = static_cast<float>(r * r - error);
  p.possible       = static_cast<float>(r * r + error);
  return p;
}

CellTable CellGrid::table() const
{
  CellTable t{begin_.data(), {n_[0], n_[1], n_[2]}, {wraps_[0], wraps_[1], wraps_[2]}, {}};
  for (int d = 0; d < 3; ++d)
    t.next_image[d] = wraps_[d] ? 1 << (image_bits * d) : 0;
  return t;
}
} // namespace ricochet
