// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/element_stress.h"

#include "shear_stress.h"

#include <Eigen/LU>

namespace ricochet
{
StressState element_stress(const FiniteElementBody &elements, const int element)
{
  const auto &material        = elements.material();
  const double K              = material.bulk_modulus;
  const Eigen::Matrix3d F     = elements.deformation_gradient(element);
  const Eigen::Matrix3d E     = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d shear = shear_stress(material, E);
  Eigen::Matrix3d S           = K * E.trace() * Eigen::Matrix3d::Identity() + shear;
  StressState state;
  state.energy_density = 0.5 * (K * E.trace() * E.trace() + shear.cwiseProduct(E).sum());
  for (std::size_t k = 0; elements.relaxes() && k < material.relaxation.size(); ++k)
  {
    const double share         = material.relaxation[k].share;
    const Eigen::Matrix3d back = elements.back_strain(element, static_cast<int>(k)),
                          left = E - back;
    S -= share * shear_stress(material, back);
    state.energy_density +=
        0.5 * share *
        (shear_stress(material, left).cwiseProduct(left).sum() - shear.cwiseProduct(E).sum());
  }
  state.stress     = F * S * F.transpose();
  state.dilatation = F.determinant() - 1.;
  return state;
}
} // namespace ricochet
