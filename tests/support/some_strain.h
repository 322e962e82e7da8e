// SPDX-License-Identifier: LGPL-2.1-or-later
// A strain and a turn that no symmetry favours, and Hooke's law.
#pragma once

#include <Eigen/Geometry>

namespace ricochet::tests
{
/// Of this size, all components different.
inline Eigen::Matrix3d some_strain(const double size)
{
  Eigen::Matrix3d strain;
  strain << 0.9, -0.3, 0.5, -0.3, -0.4, 0.2, 0.5, 0.2, 0.7;
  return size * strain;
}

inline Eigen::Matrix3d some_rotation()
{
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1., -2., 0.5).normalized()).toRotationMatrix();
}

/// Stress of a strain; `material` has the members bulk_modulus and shear_modulus [Pa].
template <class Material>
Eigen::Matrix3d hooke(const Material &material, const Eigen::Matrix3d &strain)
{
  const double mu = material.shear_modulus;
  return (material.bulk_modulus - 2. / 3. * mu) * strain.trace() * Eigen::Matrix3d::Identity() +
         2. * mu * strain;
}
} // namespace ricochet::tests
