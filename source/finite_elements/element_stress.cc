// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/element_stress.h"

#include <Eigen/LU>

namespace ricochet
{
namespace
{
Eigen::Matrix3d deviator(const Eigen::Matrix3d &E)
{
  return E - E.trace() / 3. * Eigen::Matrix3d::Identity();
}
} // namespace

StressState element_stress(const FiniteElementBody &elements, const int element)
{
  const auto &material = elements.material();
  const double K = material.bulk_modulus, mu = material.shear_modulus;
  const Eigen::Matrix3d F     = elements.deformation_gradient(element);
  const Eigen::Matrix3d E     = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d shear = deviator(E);
  Eigen::Matrix3d S           = K * E.trace() * Eigen::Matrix3d::Identity() + 2. * mu * shear;
  StressState state;
  state.energy_density = 0.5 * K * E.trace() * E.trace() + mu * shear.squaredNorm();
  for (std::size_t k = 0; elements.relaxes() && k < material.relaxation.size(); ++k)
  {
    const double share         = material.relaxation[k].share;
    const Eigen::Matrix3d back = deviator(elements.back_strain(element, static_cast<int>(k)));
    S -= 2. * mu * share * back;
    state.energy_density += mu * share * ((shear - back).squaredNorm() - shear.squaredNorm());
  }
  state.stress     = F * S * F.transpose();
  state.dilatation = F.determinant() - 1.;
  return state;
}
} // namespace ricochet
