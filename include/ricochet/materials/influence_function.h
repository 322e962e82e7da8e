// SPDX-License-Identifier: LGPL-2.1-or-later
// Influence function omega(|xi|/delta) of a bond. The cone with horizon ratio 3 is the default: it
// is the only common choice whose lattice is isotropic to 0.2 % (Silling et al. 2007 leave omega
// free).
#pragma once

#include <array>
#include <cmath>

namespace ricochet
{
enum class InfluenceFunction
{
  cone,
  constant,
  gaussian,
  inverse
};

/// One line of the menu.
struct InfluenceFunctionName
{
  InfluenceFunction function; // what it is
  const char *name;           // in parameter files
  const char *formula;        // of the bond's length r and the horizon delta
};

/// The menu.
constexpr std::array<InfluenceFunctionName, 4> influence_functions{
    {{InfluenceFunction::cone, "cone", "1 - r/delta"},
     {InfluenceFunction::constant, "constant", "1"},
     {InfluenceFunction::gaussian, "gaussian", "exp(-4 r^2/delta^2)"},
     {InfluenceFunction::inverse, "inverse", "delta/r"}}};

/// Weight of a bond of length ratio * delta; ratio in (0, 1] [-]. Returns omega >= 0 [-].
inline double influence(const InfluenceFunction function, const double ratio)
{
  switch (function)
  {
    case InfluenceFunction::cone:
      return 1. - ratio;
    case InfluenceFunction::constant:
      return 1.;
    case InfluenceFunction::gaussian:
      return std::exp(-4. * ratio * ratio);
    case InfluenceFunction::inverse:
      return 1. / ratio;
  }
  return 0.;
}
} // namespace ricochet
