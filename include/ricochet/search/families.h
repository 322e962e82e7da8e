// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of which a search is not asked which of their own family are near.
#pragma once

#include "ricochet/search/pair_loops.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ricochet
{
/// Two points belong to one family if their places are no further apart than that. Places are whole
/// numbers below 2^24, such as those in a lattice, so that the distance is exact.
struct Families
{
  std::vector<std::array<float, 3>> place; // per point; empty: there are no families
  float squared_range = 0.f;               // of the places of a family

  /// Whether the points number a and b belong to one family.
  bool share(const std::size_t a, const std::size_t b) const
  {
    if (place.empty())
      return false;
    const float dx = place[a][0] - place[b][0], dy = place[a][1] - place[b][1],
                dz = place[a][2] - place[b][2];
    return dx * dx + dy * dy + dz * dz <= squared_range;
  }
};

/// Families in the order in which pair_loops() compares the points.
class SortedFamilies
{
public:
  /// `order`: numbers of the points.
  SortedFamilies(const Families &families, const std::vector<std::int32_t> &order,
                 const std::size_t n) :
    squared_range_(families.squared_range)
  {
    for (int d = 0; d < 3 && !families.place.empty(); ++d)
    {
      place_[d].assign(n + SortedPoints::padding, 0.f);
      for (std::size_t i = 0; i < n; ++i)
        place_[d][i] = families.place[order[i]][d];
    }
  }

  /// For as long as this object lives.
  void add_to(SortedPoints &points) const
  {
    for (int d = 0; d < 3; ++d)
      points.place[d] = place_[d].empty() ? nullptr : place_[d].data();
    points.squared_family_range = squared_range_;
  }

private:
  std::array<std::vector<float>, 3> place_;
  float squared_range_;
};
} // namespace ricochet
