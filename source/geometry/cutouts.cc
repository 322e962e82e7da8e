// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/cutouts.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
// Coordinates of up to a metre are exact to 1e-16 m, and no spacing is below 1e-9 m: what lies on a
// border does so whatever the rounding, and on both sides of a mirror plane alike [m].
constexpr double rounding = 1e-12;

bool within(const double from, const double x, const double to)
{
  return from - rounding <= x && x <= to + rounding;
}

bool strictly_within(const double from, const double x, const double to)
{
  return from + rounding < x && x < to - rounding;
}
} // namespace

bool removes(const Cutouts::Hole &hole, const Vector3 &point)
{
  return std::hypot(point.x() - hole.x, point.y() - hole.y) < 0.5 * hole.diameter - rounding;
}

bool removes(const Cutouts::Notch &notch, const Vector3 &point)
{
  return strictly_within(notch.x_from, point.x(), notch.x_to) &&
         strictly_within(notch.y_from, point.y(), notch.y_to) &&
         strictly_within(notch.depth_from, point.z(), notch.depth_to);
}

bool severs(const Cutouts::Crack &crack, const Vector3 &one, const Vector3 &other)
{
  const double a = one[crack.normal] - crack.at, b = other[crack.normal] - crack.at;
  if ((a < -rounding) == (b < -rounding))
    return false;
  const Vector3 crossing = one + a / (a - b) * (other - one);
  return within(crack.from, crossing[1 - crack.normal], crack.to) &&
         within(crack.depth_from, crossing.z(), crack.depth_to);
}

bool Cutouts::removes(const Vector3 &point) const
{
  const auto at_point = [&](const auto &cutout) { return ricochet::removes(cutout, point); };
  return std::any_of(holes.begin(), holes.end(), at_point) ||
         std::any_of(notches.begin(), notches.end(), at_point);
}

bool Cutouts::severs(const Vector3 &one, const Vector3 &other) const
{
  return std::any_of(cracks.begin(), cracks.end(),
                     [&](const Crack &crack) { return ricochet::severs(crack, one, other); });
}

std::vector<std::array<double, 4>> Cutouts::columns() const
{
  std::vector<std::array<double, 4>> columns;
  for (const auto &hole : holes)
    columns.push_back(column_of(hole));
  for (const auto &notch : notches)
    columns.push_back(column_of(notch));
  for (const auto &crack : cracks)
    columns.push_back(column_of(crack));
  return columns;
}

bool is_symmetric(const Cutouts::Hole &hole)
{
  return std::abs(hole.y) < rounding;
}

bool is_symmetric(const Cutouts::Notch &notch)
{
  return std::abs(notch.y_from + notch.y_to) < rounding;
}

bool is_symmetric(const Cutouts::Crack &crack)
{
  return std::abs(crack.normal == 1 ? crack.at : crack.from + crack.to) < rounding;
}

std::array<double, 4> column_of(const Cutouts::Hole &hole)
{
  const double r = 0.5 * hole.diameter;
  return {hole.x - r, hole.x + r, hole.y - r, hole.y + r};
}

std::array<double, 4> column_of(const Cutouts::Notch &notch)
{
  return {notch.x_from, notch.x_to, notch.y_from, notch.y_to};
}

std::array<double, 4> column_of(const Cutouts::Crack &crack)
{
  if (crack.normal == 0)
    return {crack.at, crack.at, crack.from, crack.to};
  return {crack.from, crack.to, crack.at, crack.at};
}
} // namespace ricochet
