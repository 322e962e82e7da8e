// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that decays with the sliding speed, mu(v) = mu_inf + (mu_0 - mu_inf) exp(-gamma v): the
// exponential dynamic Coulomb law of the explicit impact codes (PRONTO, LS-DYNA: FS, FD, DC).
#pragma once

#include "ricochet/contact/friction_law.h"

#include <cmath>

namespace ricochet
{
class ExponentialFriction : public FrictionLaw
{
public:
  static constexpr const char *name = "exponential"; // in parameter files

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
  explicit ExponentialFriction(const Parameters &parameters) :
    mu_0(parameters.static_coefficient), mu_inf(parameters.kinetic_coefficient),
    gamma(parameters.decay)
  {
  }

  double coefficient(const double speed) const override
  {
    return mu_inf + (mu_0 - mu_inf) * std::exp(-gamma * speed);
  }

private:
  double mu_0;   // [-]
  double mu_inf; // [-]
  double gamma;  // [s/m]
};
} // namespace ricochet
