// SPDX-License-Identifier: LGPL-2.1-or-later
// What kind of quantity a number is, and which values it may take: said beside the number, so that
// parameter files, their checks and their documentation need not say it again. The units of each
// kind stand in scene/quantity.h.
#pragma once

namespace ricochet
{
enum class Dimension
{
  number, // dimensionless, written without a unit
  length,
  time,
  mass,
  angle,
  angular_velocity,
  speed,
  slowness, // inverse speed
  density,
  stress,
  surface_energy
};

/// Values a quantity may take.
enum class Limit
{
  any,
  not_negative,
  positive,
  fraction // 0 to 1, both included
};
} // namespace ricochet
