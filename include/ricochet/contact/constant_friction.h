// SPDX-License-Identifier: LGPL-2.1-or-later
// Coulomb's law with one coefficient, mu(v) = mu_0.
#pragma once

#include "ricochet/contact/friction_law.h"

namespace ricochet
{
class ConstantFriction : public FrictionLaw
{
public:
  static constexpr const char *name = "constant"; // in parameter files

  /// The constants of the law.
  struct Parameters
  {
    double static_coefficient; // mu_0 [-]
  };

  /// Their entries in parameter files.
  static constexpr EntryRow<Parameters> entries[] = {
      static_friction(&Parameters::static_coefficient)};

  /// The constants keep the limits of their entries.
  explicit ConstantFriction(const Parameters &parameters) : mu_0(parameters.static_coefficient) {}

  double coefficient(double) const override { return mu_0; }

private:
  double mu_0; // [-]
};
} // namespace ricochet
