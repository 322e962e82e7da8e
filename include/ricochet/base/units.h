// SPDX-License-Identifier: LGPL-2.1-or-later
// Units: everything inside the program is SI; these constants only make literals readable.
// A parameter text names its unit, see scene/quantity.h for the conversion.
#pragma once

namespace ricochet::units
{
constexpr double mm  = 1e-3;                         // [m]
constexpr double us  = 1e-6;                         // [s]
constexpr double g   = 1e-3;                         // [kg]
constexpr double MPa = 1e6;                          // [Pa]
constexpr double GPa = 1e9;                          // [Pa]
constexpr double deg = 3.14159265358979323846 / 180; // [rad]
} // namespace ricochet::units
