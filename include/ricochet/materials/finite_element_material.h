// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ricochet/materials/relaxation.h"

namespace ricochet
{
/// Of a cubic solid whose axes are those of the elements; 1 and 1: isotropic.
struct CubicAnisotropy
{
  double tetragonal = 1.; // (C11 - C12)/2 over the shear modulus [-]
  double diagonal   = 1.; // C44 over the shear modulus [-]
};

/// St Venant-Kirchhoff, with a shear modulus that may relax.
struct FiniteElementMaterial
{
  double density;       // [kg/m^3]
  double bulk_modulus;  // [Pa]
  double shear_modulus; // [Pa], the instantaneous one
  /// Of the shear modulus; takes effect by FiniteElementBody::start_relaxation().
  RelaxationSeries relaxation = {};
  CubicAnisotropy anisotropy  = {}; // of the shear modulus
};
} // namespace ricochet
