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

// R/(d sqrt(N)), see ricochet_radius(): the mean of runs of the single plate at 720 m/s and 10, 20
// and 30 degrees, R = 110 mm; runs with other speeds, masses, calibres and strengths have 0.7 to
// 1.25 times as much (doc/coupling.md).
constexpr double arc_factor = 1.315;

// All lengths along x, from the entry point on [m].
struct Path
{
  double before;   // this plate is reached, if nothing bends the path
  double straight; // it is left again
  double arc;      // a ricochet is over
};

Path path_of(const ImpactOnPlate &impact)
{
  const double tangent = std::tan(impact.incidence_angle);
  return {impact.depth / tangent, (impact.depth + impact.thickness) / tangent,
          2. * ricochet_radius(impact) * std::sin(impact.incidence_angle)};
}

double side_of(const ImpactOnPlate &impact)
{
  return half_width * impact.calibre + interface_margin * impact.horizon;
}
} // namespace

double ricochet_radius(const ImpactOnPlate &impact)
{
  const double d = impact.calibre;
  const double N = impact.mass * impact.speed * impact.speed / (impact.strength * d * d * d);
  return arc_factor * d * std::sqrt(N);
}

ZoneChoice corridor_zone(const ImpactOnPlate &impact)
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

ZoneChoice growth_limit(const ImpactOnPlate &impact)
{
  const auto [before, straight, arc] = path_of(impact);
  const double side                  = side_of(impact);
  return {impact.entry_x + before - side, impact.entry_x + std::max(arc, straight) + impact.length,
          impact.entry_y - side, impact.entry_y + side, ""};
}

double growth_ahead(const ImpactOnPlate &impact)
{
  return impact.calibre + interface_margin * impact.horizon;
}

ZoneChoice entry_zone(const ImpactOnPlate &impact)
{
  const double tangent = std::tan(impact.incidence_angle);
  const double before  = impact.depth / tangent;
  const double side    = impact.calibre + interface_margin * impact.horizon;
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
