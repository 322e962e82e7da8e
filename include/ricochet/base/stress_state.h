// SPDX-License-Identifier: LGPL-2.1-or-later
// What a piece of material feels, the same of points and of elements, and the scalars by which it
// is looked at.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace ricochet
{
struct StressState
{
  /// Kirchhoff's stress tau: Cauchy's times the ratio of volumes, per area as if the volume had
  /// stayed; turns with the material [Pa].
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  double dilatation      = 0.; // relative change of the volume [-]
  double energy_density  = 0.; // stored, per volume of the reference configuration [J/m^3]
};

/// -tr(stress)/3, positive when compressed [Pa].
inline double pressure(const Eigen::Matrix3d &stress)
{
  return -stress.trace() / 3.;
}

/// sqrt(3/2 s : s) with the deviator s; in simple tension the stress itself [Pa].
inline double von_mises(const Eigen::Matrix3d &stress)
{
  const Eigen::Matrix3d deviator = stress + pressure(stress) * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}
} // namespace ricochet
