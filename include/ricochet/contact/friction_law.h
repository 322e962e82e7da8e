// SPDX-License-Identifier: LGPL-2.1-or-later
// Interface of a Coulomb friction law: the coefficient as a function of the sliding speed.
// A new law is one header beside this one, one line in contact/friction_laws.h and one in
// tests/support/laws.h.
#pragma once

#include <string>

namespace ricochet
{
/// Constants shared by the friction laws; each law says in its header which of them it reads.
struct FrictionParameters
{
  std::string law;             // name in contact/friction_laws.h
  double static_coefficient;   // mu_0, at rest [-]
  double kinetic_coefficient;  // mu_inf, at high speed [-]
  double decay;                // gamma [s/m]
  double regularisation_speed; // below it the friction force falls linearly to zero [m/s]
};

class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;

  /// Friction coefficient [-] at the relative tangential speed [m/s], speed >= 0.
  virtual double coefficient(double speed) const = 0;
};
} // namespace ricochet
