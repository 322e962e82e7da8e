// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear peridynamic solid, ordinary state-based (Silling, Epton, Weckner, Xu, Askari 2007, section
// 15):
//   theta = (3/m) sum omega |xi| e V,   W = (K - 5 mu/3) theta^2 / 2 + (15 mu/m) / 2 sum omega e^2
//   V
// so that the tension of the bond between i and j, both ends together, is
//   t = V^2 omega [ (3K - 5 mu)/m |xi| (theta_i + theta_j) + (30 mu/m) e ].
#pragma once

#include "ricochet/materials/bond_law.h"

namespace ricochet
{
struct LinearPeridynamicSolid
{
  static constexpr const char *name    = "linear peridynamic solid"; // in parameter files
  static constexpr bool has_dilatation = true;                       // theta enters the tension

  /// Poisson's ratio is free.
  static constexpr bool fixes_poisson_ratio = false;

  /// Constants of a bond of a length [m] and an influence function [-].
  static BondConstants bond(const FamilyConstants &f, const double length, const double omega)
  {
    const double v2 = f.volume * f.volume;
    return {length, 0., 3. / f.weighted_volume * omega * length * f.volume,
            v2 * omega * (3. * f.bulk_modulus - 5. * f.shear_modulus) / f.weighted_volume * length,
            v2 * omega * 30. * f.shear_modulus / f.weighted_volume};
  }

  /// Energy of a point per theta^2 [J].
  static double point_stiffness(const FamilyConstants &f)
  {
    return 0.5 * (f.bulk_modulus - 5. / 3. * f.shear_modulus) * f.volume;
  }

  /// Tension of a bond [N] from its extension [m] and theta_i + theta_j [-].
  template <class T>
  static T tension(const T &volumetric, const T &extension_stiffness, const T &extension,
                   const T &theta_sum)
  {
    return volumetric * theta_sum + extension_stiffness * extension;
  }

  /// Energy of a bond, both ends together, without the points' theta^2 part [J].
  template <class T>
  static T bond_energy(const T &extension_stiffness, const T &extension)
  {
    return 0.5 * extension_stiffness * extension * extension;
  }
};
} // namespace ricochet
