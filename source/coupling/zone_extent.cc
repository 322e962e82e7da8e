// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/coupling/zone_extent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ricochet
{
namespace
{
constexpr double half_width = 1.5; // beside the path [calibres]
constexpr double run_out    = 5.;  // beyond the path [calibres]
// The interface must keep away from what breaks.
constexpr double margin     = 2.; // [horizons]

// A ricochet's path is an arc. 0.3 in at 720 m/s: radius 110 mm; it grows with calibre and energy.
constexpr double arc_radius = 110e-3, arc_calibre = 6.17e-3, arc_speed = 720.; // [m], [m], [m/s]

// All lengths along x, from the entry point on [m].
struct Path
{
  double before;   // this plate is reached, if nothing bends the path
  double straight; // it is left again
  double arc;      // a ricochet is over
};

Path path_of(const ImpactGeometry &impact)
{
  const double radius =
      arc_radius * impact.calibre / arc_calibre * std::pow(impact.speed / arc_speed, 2);
  const double tangent = std::tan(impact.incidence_angle);
  return {impact.depth / tangent, (impact.depth + impact.thickness) / tangent,
          2. * radius * std::sin(impact.incidence_angle)};
}

double side_of(const ImpactGeometry &impact)
{
  return half_width * impact.calibre + margin * impact.horizon;
}
} // namespace

ZoneChoice corridor_zone(const ImpactGeometry &impact)
{
  const auto [before, straight, arc] = path_of(impact);
  const double path                  = std::min(straight, std::max(arc, before));
  const double side                  = side_of(impact);
  const double ahead                 = path + impact.length + run_out * impact.calibre;
  ZoneChoice choice{impact.entry_x + std::min(before, path) - side, impact.entry_x + ahead,
                    impact.entry_y - side, impact.entry_y + side, ""};
  char text[300];
  std::snprintf(
      text, sizeof text,
      "half width %.3g mm = 1.5 calibres + 2 horizons; length %.3g mm = path %.3g mm (%s) + "
      "projectile + 5 calibres ahead, the half width behind",
      1e3 * side, 1e3 * (choice.x_high - choice.x_low), 1e3 * path,
      straight <= arc ? "straight through the plate" : "arc of a ricochet");
  choice.reason = text;
  return choice;
}

ZoneChoice growth_limit(const ImpactGeometry &impact)
{
  const auto [before, straight, arc] = path_of(impact);
  const double side                  = side_of(impact);
  return {impact.entry_x + before - side, impact.entry_x + std::max(arc, straight) + impact.length,
          impact.entry_y - side, impact.entry_y + side, ""};
}

double growth_ahead(const ImpactGeometry &impact)
{
  return impact.calibre + margin * impact.horizon;
}

ZoneChoice entry_zone(const ImpactGeometry &impact)
{
  const double tangent = std::tan(impact.incidence_angle);
  const double before  = impact.depth / tangent;
  const double side    = impact.calibre + margin * impact.horizon;
  ZoneChoice choice{impact.entry_x + before - side, impact.entry_x + before + side + impact.calibre,
                    impact.entry_y - side, impact.entry_y + side, ""};
  char text[300];
  std::snprintf(text, sizeof text,
                "the entry point with one calibre and two horizons around it; it grows with the "
                "damage and follows the projectile");
  choice.reason = text;
  return choice;
}
} // namespace ricochet
