// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction of asperities that soften by their own heat: each contact of two asperities lives as
// long as it takes to slide over its width, and above the weakening speed V_w it spends part of
// that at the temperature at which it has lost its strength,
//   mu(v) = mu_w + (mu_0 - mu_w) / [1 + (v/V_w)^8]^(1/8).
// Far above V_w this is Rice's mu_w + (mu_0 - mu_w) V_w/v (2006, J. Geophys. Res. 111, B05311),
// far below it mu_0; the smooth transition is the one of Noda, Dunham and Rice (2009, J. Geophys.
// Res. 114, B07302). V_w = pi (alpha/D) [rho c (T_w - T)/tau]^2 for asperities of the width D, the
// diffusivity alpha and the strength tau that weaken at T_w.
#pragma once

#include "ricochet/contact/friction_law.h"

#include <cmath>

namespace ricochet
{
class FlashHeatingFriction : public FrictionLaw
{
public:
  static constexpr const char *name = "flash heating"; // in parameter files

  /// The constants of the law.
  struct Parameters
  {
    double static_coefficient;  // mu_0, at rest [-]
    double kinetic_coefficient; // mu_w, of asperities that have lost their strength [-]
    double weakening_speed;     // V_w [m/s]
  };

  /// Their entries in parameter files.
  static constexpr EntryRow<Parameters> entries[] = {
      static_friction(&Parameters::static_coefficient),
      kinetic_friction(&Parameters::kinetic_coefficient),
      {"Weakening speed", &Parameters::weakening_speed, Dimension::speed, Limit::positive, "1 m/s",
       "Sliding speed above which asperities soften by their own heat"}};

  /// The constants keep the limits of their entries.
  explicit FlashHeatingFriction(const Parameters &parameters) :
    mu_0(parameters.static_coefficient), mu_w(parameters.kinetic_coefficient),
    V_w(parameters.weakening_speed)
  {
  }

  double coefficient(const double speed) const override
  {
    const double ratio = speed / V_w, squared = ratio * ratio, fourth = squared * squared;
    return mu_w + (mu_0 - mu_w) / std::sqrt(std::sqrt(std::sqrt(1. + fourth * fourth)));
  }

private:
  double mu_0; // [-]
  double mu_w; // [-]
  double V_w;  // [m/s]
};
} // namespace ricochet
