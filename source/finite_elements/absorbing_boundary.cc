// SPDX-License-Identifier: LGPL-2.1-or-later
// The dashpots of FiniteElementBody.
#include "ricochet/finite_elements/finite_element_body.h"

#include <cmath>

namespace ricochet
{
void FiniteElementBody::absorb_at(const std::array<bool, 6> &faces)
{
  const auto &box  = mesh_.box();
  const double rho = material_.density;
  const double c_p = std::sqrt((material_.bulk_modulus + 4. / 3. * material_.shear_modulus) / rho),
               c_s = std::sqrt(material_.shear_modulus / rho);
  std::vector<double> coefficient(force_.size(), 0.);
  for (const auto &element : mesh_.elements())
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2, side = face % 2;
      const double plane = box.corner[axis] + side * box.n[axis] * box.edge;
      for (int corner = 0; corner < 8; ++corner)
      {
        const int node = element.nodes[corner];
        if (!faces[face] || ((corner >> axis) & 1) != side ||
            std::abs(mesh_.reference_position(node)[axis] - plane) > 1e-6 * element.edge)
          continue;
        for (int d = 0; d < 3; ++d)
          coefficient[3 * node + d] +=
              rho * (d == axis ? c_p : c_s) * element.edge * element.edge / 4.;
      }
    }
  mesh_.add_to_owners(coefficient.data());
  dashpots_.clear();
  for (int i = 0; i < 3 * mesh_.n_owned_nodes(); ++i)
    if (coefficient[i] > 0.)
      dashpots_.push_back({i, coefficient[i]});
}

/// v+ = ((1 - q) v- + dt f/m)/(1 + q) with q = c dt/2m: stable for any c, and as accurate as the
/// leapfrog scheme around it.
double FiniteElementBody::damped_force(const Dashpot &dashpot, const double dt) const
{
  const int i    = dashpot.entry;
  const double q = 0.5 * dashpot.coefficient * dt * inverse_mass_[i];
  return (force_[i] - dashpot.coefficient * velocity_[i]) / (1. + q);
}
} // namespace ricochet
