// SPDX-License-Identifier: LGPL-2.1-or-later
// All pairs of points closer than a radius, by a grid of cells of that size. Only occupied cells
// are stored, so a few far-flung fragments cost nothing.
#pragma once

#include "ricochet/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ricochet
{
class LinkedCells
{
public:
  /// Sorts the points into cells. `radius` > 0 in the unit of the points. Pairs of two points which
  /// are both not `active` are of no interest; `active` has one entry per point.
  LinkedCells(const std::vector<Vector3> &points, const std::vector<char> &active,
              const double radius) :
    radius_(radius)
  {
    std::vector<std::pair<std::uint64_t, int>> sorted(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      sorted[i] = {key(cell(points[i].x()), cell(points[i].y()), cell(points[i].z())),
                   static_cast<int>(i)};
    std::sort(sorted.begin(), sorted.end());
    points_.reserve(points.size());
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      if (i == 0 || sorted[i].first != keys_.back())
      {
        keys_.push_back(sorted[i].first);
        begin_.push_back(i);
        active_.push_back(0);
      }
      order_.push_back(sorted[i].second);
      points_.push_back(points[sorted[i].second]);
      active_.back() |= active[sorted[i].second];
    }
    begin_.push_back(sorted.size());
  }

  /// Calls visit(i, j) once for each pair with |x_i - x_j| < radius, in no particular order.
  template <class Visitor>
  void for_each_pair(Visitor &&visit) const
  {
    for (std::size_t c = 0; c < keys_.size(); ++c)
    {
      // In key order a column of three cells along z is one run; half of the neighbouring columns
      // are enough.
      visit_cells(c, c, visit);
      if (c + 1 < keys_.size() && keys_[c + 1] == keys_[c] + 1)
        visit_cells(c, c + 1, visit);
      for (const auto &[dx, dy] : {std::pair<int, int>{0, 1}, {1, -1}, {1, 0}, {1, 1}})
      {
        const std::uint64_t column = keys_[c] + key_step(dx, dy);
        auto other                 = std::lower_bound(keys_.begin() + c, keys_.end(), column - 1);
        for (; other != keys_.end() && *other <= column + 1; ++other)
          visit_cells(c, other - keys_.begin(), visit);
      }
    }
  }

private:
  static constexpr int bits = 21; // per axis: two million cells either way

  std::int64_t cell(const double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / radius_));
  }
  static std::uint64_t key(const std::int64_t x, const std::int64_t y, const std::int64_t z)
  {
    const std::int64_t offset = std::int64_t(1) << (bits - 1);
    return (std::uint64_t(x + offset) << (2 * bits)) + (std::uint64_t(y + offset) << bits) +
           std::uint64_t(z + offset);
  }
  static std::uint64_t key_step(const int dx, const int dy)
  {
    return std::uint64_t(std::int64_t(dx) * (std::int64_t(1) << (2 * bits)) +
                         std::int64_t(dy) * (std::int64_t(1) << bits));
  }

  template <class Visitor>
  void visit_cells(const std::size_t c, const std::size_t other, Visitor &visit) const
  {
    if (!active_[c] && !active_[other])
      return;
    for (std::size_t i = begin_[c]; i < begin_[c + 1]; ++i)
      for (std::size_t j = c == other ? i + 1 : begin_[other]; j < begin_[other + 1]; ++j)
        if ((points_[i] - points_[j]).squaredNorm() < radius_ * radius_)
          visit(order_[i], order_[j]);
  }

  double radius_;
  std::vector<Vector3> points_;     // in key order, like order_
  std::vector<int> order_;          // their numbers
  std::vector<std::uint64_t> keys_; // of the occupied cells, ascending
  std::vector<std::size_t> begin_;  // first point of each cell
  std::vector<char> active_;        // whether a cell has an active point
};
} // namespace ricochet
