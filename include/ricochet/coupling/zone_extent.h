// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a plate must be peridynamic: the corridor that an impact damages, from calibre, speed,
// angle and thickness.
#pragma once

#include "ricochet/base/vector.h"

#include <string>

namespace ricochet
{
/// What the choice depends on.
struct ImpactGeometry
{
  double calibre;         // [m]
  double length;          // of the projectile [m]
  double speed;           // [m/s]
  double incidence_angle; // between velocity and surface [rad]
  double entry_x;         // on the first plate [m]
  double entry_y;         // likewise [m]
  double depth;           // of the plate's upper face below that of the first [m]
  double thickness;       // of the plate [m]
  double horizon;         // [m]
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

/// The corridor of the whole event. 1.5 calibres to each side, plus what the interface must keep
/// away; as long as a straight path through the plate or the arc of a ricochet, whichever is
/// shorter, plus the projectile and five calibres. In ensembles of the base case path and exit
/// speed do not change with more width; a shorter corridor stops the projectile at its end
/// (doc/coupling.md).
ZoneChoice corridor_zone(const ImpactGeometry &impact);

/// Only what the first moments need; for zones that grow.
ZoneChoice entry_zone(const ImpactGeometry &impact);

/// The largest zone that a growing one may become: as wide as the corridor, and as long as the arc
/// of a ricochet or the straight path, whichever is longer, plus the projectile.
ZoneChoice growth_limit(const ImpactGeometry &impact);

/// A growing zone stays so far ahead of the projectile [m].
double growth_ahead(const ImpactGeometry &impact);
} // namespace ricochet
