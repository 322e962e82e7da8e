// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ricochet/materials/finite_element_material.h"

#include <Eigen/Core>

namespace ricochet
{
/// What a strain does through the shear modulus, before anything relaxes: 2 mu times its deviator
/// in an isotropic solid [Pa].
inline Eigen::Matrix3d shear_stress(const FiniteElementMaterial &material, const Eigen::Matrix3d &E)
{
  const double mu   = material.shear_modulus;
  Eigen::Matrix3d S = 2. * mu * material.anisotropy.diagonal * E;
  for (int d = 0; d < 3; ++d)
    S(d, d) = 2. * mu * material.anisotropy.tetragonal * (E(d, d) - E.trace() / 3.);
  return S;
}
} // namespace ricochet
