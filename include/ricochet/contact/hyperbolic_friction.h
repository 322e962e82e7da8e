// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls like 1/v at high speed, mu(v) = mu_inf + (mu_0 - mu_inf)/(1 + gamma v). A
// form to fit measured coefficients with, no mechanism behind it: the first term of the rational
// falling friction of the rolling contact code CONTACT (Vollebregt, User guide for CONTACT,
// Technical Report TR09-03, L = 3), where 1/gamma is the slip velocity at which the term is halved.
// Its tail is longer than the exponential law's.
#pragma once

#include "ricochet/contact/friction_law.h"

namespace ricochet
{
class HyperbolicFriction : public FrictionLaw
{
public:
  static constexpr const char *name = "hyperbolic"; // in parameter files

  /// The constants of the law.
  struct Parameters
  {
    double static_coefficient;  // mu_0, at rest [-]
    double kinetic_coefficient; // mu_inf, at high speed [-]
    double decay;               // gamma [s/m]
  };

  /// Their entries in parameter files.
  static constexpr EntryRow<Parameters> entries[] = {
      static_friction(&Parameters::static_coefficient),
      kinetic_friction(&Parameters::kinetic_coefficient), friction_decay(&Parameters::decay)};

  /// The constants keep the limits of their entries.
  explicit HyperbolicFriction(const Parameters &parameters) :
    mu_0(parameters.static_coefficient), mu_inf(parameters.kinetic_coefficient),
    gamma(parameters.decay)
  {
  }

  double coefficient(const double speed) const override
  {
    return mu_inf + (mu_0 - mu_inf) / (1. + gamma * speed);
  }

private:
  double mu_0;   // [-]
  double mu_inf; // [-]
  double gamma;  // [s/m]
};
} // namespace ricochet
