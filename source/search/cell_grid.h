// SPDX-License-Identifier: LGPL-2.1-or-later
// Points sorted into cubic cells. Where points are far apart the grid wraps around: cells a period
// apart share their place, which costs a few needless comparisons but keeps the number of cells in
// proportion to that of the points, however far a few fragments have flown.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/search/pair_loops.h"

#include <array>
#include <vector>

namespace ricochet
{
class CellGrid
{
public:
  /// Cells a little larger than `radius` [m], > 0. Points [m] that are not finite are in no cell.
  /// With `active` (one entry per point), points that are neither active nor in or beside a cell
  /// with an active point are left out; empty: all are active.
  CellGrid(const std::vector<Vector3> &points, const std::vector<char> &active, double radius);

  /// The points which have not been left out, by their numbers, cell by cell.
  const std::vector<std::int32_t> &order() const { return order_; }
  std::int64_t n_cells() const { return static_cast<std::int64_t>(begin_.size()) - 2; }

  /// For pair_loops(); lives as long as this object, `points` and `active` must too.
  SortedPoints sorted_points() const;
  CellTable table() const;

private:
  struct Place
  {
    std::int32_t cell, image;
    float u[3];
  };

  void choose_cells(const std::vector<Vector3> &points);
  Place place(const Vector3 &x) const;
  std::vector<char> cells_near(const std::vector<Place> &places,
                               const std::vector<char> &active) const;
  void sort(const std::vector<Place> &places, const std::vector<char> &active);

  double radius_, size_; // [m]
  const double *position_;
  Vector3 low_;
  double extent_ = 0.; // of all points [cells]
  std::array<std::int32_t, 3> n_{};
  std::array<bool, 3> wraps_{};
  std::array<int, 3> log2_{}; // of n, where the grid wraps

  std::vector<std::int32_t> begin_; // and one entry more, so that begin[c + 2] may be read
  std::vector<std::int32_t> order_, image_, active_;
  std::array<std::vector<float>, 3> u_;
};
} // namespace ricochet
