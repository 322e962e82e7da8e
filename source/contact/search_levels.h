// SPDX-License-Identifier: LGPL-2.1-or-later
// Points are searched level by level, those with thin skins first: a radius that suits the fastest
// fragment would bring up all of the slow ones' distant neighbours.
#pragma once

#include "candidate_search.h"

#include <algorithm>

namespace ricochet
{
/// No point's skin is thicker [spacings]; what is faster leaves it earlier and is searched alone.
/// This and the limits below only share out the cost; they were chosen by judgement, no measurement
/// is kept.
constexpr double thickest_skin  = 2.25;
constexpr double level_limits[] = {0.25, 0.75,
                                   thickest_skin}; // thickest skin of a level [spacings]
constexpr int n_levels          = 3;

/// Edge of the coarse cells that tell where points are [spacings]: above a point's range and
/// thickest skin together, 1.35 + 2.25, so that each point lies in a few cells only.
constexpr double coarse_cell = 4.;

inline bool is_of_level(const ContactPoint &point, const int level, const double spacing)
{
  return (level == 0 || point.skin > level_limits[level - 1] * spacing) &&
         point.skin <= level_limits[level] * spacing;
}

inline bool level_has_points(const std::vector<ContactPoint> &points, const int level,
                             const double spacing)
{
  return std::any_of(points.begin(), points.end(),
                     [&](const ContactPoint &point) { return is_of_level(point, level, spacing); });
}

/// The points up to a level, and which of them must be in a pair.
struct LevelPoints
{
  std::vector<std::int32_t> number; // among all points
  std::vector<Vector3> position;    // [m]
  std::vector<char> active;
  std::vector<std::int64_t> id; // in ContactNumbering
};

/// Of the first `n_points` points. `spacing` in m.
LevelPoints points_up_to_level(const std::vector<ContactPoint> &points, std::size_t n_points,
                               int level, double spacing);

/// Within which pairs of a level are found [m].
inline double radius_of_level(const int level, const CandidateSearch::Parameters &parameters)
{
  return parameters.range + 2. * level_limits[level] * parameters.spacing;
}
} // namespace ricochet
