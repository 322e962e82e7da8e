// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ricochet/materials/relaxation.h"

namespace ricochet
{
/// St Venant-Kirchhoff, with a shear modulus that may relax.
struct FiniteElementMaterial
{
  double density;       // [kg/m^3]
  double bulk_modulus;  // [Pa]
  double shear_modulus; // [Pa], the instantaneous one
  /// Of the shear modulus; takes effect by FiniteElementBody::start_relaxation().
  RelaxationSeries relaxation = {};
};
} // namespace ricochet
