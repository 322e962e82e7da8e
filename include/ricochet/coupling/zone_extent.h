// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a plate must be peridynamic: the corridor that an impact damages. Similar impacts have
// similar corridors: nothing but ratios of what the scene says decides.
#pragma once

#include "ricochet/base/vector.h"

#include <string>

namespace ricochet
{
/// The interface keeps so far away from what breaks and from what is broken or missing from the
/// start: points that feel elements, and their neighbours, then have all of theirs [horizons].
constexpr double interface_margin = 2.;

/// What the choice depends on.
struct ImpactOnPlate
{
  double calibre;         // d [m]
  double length;          // of the projectile [m]
  double mass;            // of the projectile, m [kg]
  double speed;           // v [m/s]
  double incidence_angle; // between velocity and surface [rad]
  double entry_x;         // on the first plate [m]
  double entry_y;         // likewise [m]
  double depth;           // of the plate's upper face below that of the first [m]
  double thickness;       // of the plate [m]
  double horizon;         // [m]
  double strength;        // sigma = E s_c, the least of this plate and those above, > 0 [Pa]
};

/// A column through the whole plate, x from and to, y from and to.
struct ZoneChoice
{
  double x_low;       // [m]
  double x_high;      // [m]
  double y_low;       // [m]
  double y_high;      // [m]
  std::string reason; // for the user, one line
};

/// Radius of the arc that a ricochet flies, R = c d sqrt(N) with N = m v^2/(sigma d^3) [m]. A
/// projectile that ploughs at the depth h presses on an area of about d h, and is lifted by sigma d
/// h: it swings through the plate in half a period, pi sqrt(m/(sigma d)), and all lengths of its
/// path go as v sqrt(m/(sigma d)) = d sqrt(N). c from runs (doc/coupling.md).
double ricochet_radius(const ImpactOnPlate &impact);

/// The corridor of the whole event. 1.5 calibres to each side, plus what the interface must keep
/// away; as long as a straight path through the plate or the arc of a ricochet, whichever is
/// shorter, plus the projectile and five calibres. In ensembles of the base case path and exit
/// speed do not change with more width; a shorter corridor stops the projectile at its end
/// (doc/coupling.md).
ZoneChoice corridor_zone(const ImpactOnPlate &impact);

/// Only what the first moments need; for zones that grow.
ZoneChoice entry_zone(const ImpactOnPlate &impact);

/// The largest zone that a growing one may become: as wide as the corridor, and as long as the arc
/// of a ricochet or the straight path, whichever is longer, plus the projectile.
ZoneChoice growth_limit(const ImpactOnPlate &impact);

/// A growing zone stays so far ahead of the projectile [m].
double growth_ahead(const ImpactOnPlate &impact);
} // namespace ricochet
