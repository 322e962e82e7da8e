// SPDX-License-Identifier: LGPL-2.1-or-later
// Peridynamics as it stands in the papers: every point has a list of neighbours, nothing is
// vectorised, nothing is shared between the two ends of a bond. Slow, plain, and the oracle of the
// lattice kernels.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/materials/bond_laws.h"
#include "ricochet/materials/influence_function.h"

#include <cmath>
#include <vector>

namespace ricochet::tests
{
class ReferenceFamilies
{
public:
  struct Neighbour
  {
    int point;
    BondConstants constants;
    bool intact;
  };

  /// Points at the given reference positions of a cubic lattice of that spacing [m].
  ReferenceFamilies(const std::vector<Vector3> &reference, const double spacing,
                    const double horizon_ratio, const InfluenceFunction influence_function,
                    const BondLaw &law, const double bulk_modulus, const double shear_modulus) :
    position(reference),
    law_(law)
  {
    const double horizon = horizon_ratio * spacing;
    const double volume  = spacing * spacing * spacing;
    // Sums over the full family in the bulk, fixed for ever, also for points near a surface.
    FamilyConstants family{bulk_modulus, shear_modulus, volume, 0., 0.};
    const int n = static_cast<int>(horizon_ratio) + 1;
    for (int x = -n; x <= n; ++x)
      for (int y = -n; y <= n; ++y)
        for (int z = -n; z <= n; ++z)
          if (const double r = spacing * std::sqrt(x * x + y * y + z * z);
              r > 0. && r <= horizon * (1. + 1e-6))
          {
            const double omega = influence(influence_function, std::min(1., r / horizon));
            family.weighted_volume += omega * r * r * volume;
            family.first_moment += omega * r * volume;
          }
    point_stiffness_ = law.point_stiffness(family);

    neighbours.resize(reference.size());
    for (std::size_t i = 0; i < reference.size(); ++i)
      for (std::size_t j = 0; j < reference.size(); ++j)
      {
        const double r = (reference[j] - reference[i]).norm();
        if (i == j || r > horizon * (1. + 1e-6))
          continue;
        const double omega = influence(influence_function, std::min(1., r / horizon));
        if (omega > 1e-9)
          neighbours[i].push_back({static_cast<int>(j), law.bond(family, r, omega), true});
      }
  }

  /// Breaks what is stretched beyond the critical stretch [-].
  void break_bonds(const double critical_stretch)
  {
    for (std::size_t i = 0; i < position.size(); ++i)
      for (auto &n : neighbours[i])
        if (extension(i, n) > critical_stretch * n.constants.length)
          n.intact = false;
  }

  /// Fills dilatation, force and energy from the positions.
  void evaluate()
  {
    const std::size_t n_points = position.size();
    dilatation.assign(n_points, 0.);
    energy.assign(n_points, 0.);
    force.assign(n_points, Vector3::Zero());
    for (std::size_t i = 0; i < n_points; ++i)
      for (const auto &n : neighbours[i])
        if (n.intact)
          dilatation[i] += n.constants.dilatation * extension(i, n);
    for (std::size_t i = 0; i < n_points; ++i)
    {
      energy[i] = point_stiffness_ * dilatation[i] * dilatation[i];
      for (const auto &n : neighbours[i])
        if (n.intact)
        {
          const double e       = extension(i, n);
          const double tension = law_.tension(n.constants, e, dilatation[i] + dilatation[n.point]);
          force[i] += tension * (position[n.point] - position[i]).normalized();
          energy[i] += 0.5 * law_.bond_energy(n.constants, e); // the other half is the neighbour's
        }
    }
  }

  std::vector<Vector3> position; // current [m]
  std::vector<std::vector<Neighbour>> neighbours;
  std::vector<double> dilatation; // [-]
  std::vector<Vector3> force;     // [N]
  std::vector<double> energy;     // [J]

private:
  double extension(const std::size_t i, const Neighbour &n) const
  {
    return (position[n.point] - position[i]).norm() - n.constants.length;
  }

  BondLaw law_;
  double point_stiffness_; // [J]
};
} // namespace ricochet::tests
