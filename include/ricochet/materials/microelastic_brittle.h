// SPDX-License-Identifier: LGPL-2.1-or-later
// Prototype microelastic brittle material, bond-based (Silling and Askari 2005, equations 21 to
// 26), calibrated on the lattice instead of the full sphere:  t = c omega V^2 e / |xi|,  c = 18 K /
// sum omega |xi| V. Poisson's ratio is 1/4 by construction: mu = 3K/5.
#pragma once

#include "ricochet/materials/bond_law.h"

namespace ricochet
{
struct MicroelasticBrittle
{
  static constexpr const char *name         = "microelastic brittle"; // in parameter files
  static constexpr bool has_dilatation      = false;                  // bonds know only themselves
  static constexpr bool fixes_poisson_ratio = true;                   // at 1/4

  /// Constants of a bond of a length [m] and an influence function [-].
  static BondConstants bond(const FamilyConstants &f, const double length, const double omega)
  {
    return {length, 0., 0., 0.,
            18. * f.bulk_modulus / f.first_moment * omega * f.volume * f.volume / length};
  }

  /// Energy of a point per theta^2 [J]: none.
  static double point_stiffness(const FamilyConstants &) { return 0.; }

  /// Tension of a bond [N] from its extension [m].
  template <class T>
  static T tension(const T &, const T &extension_stiffness, const T &extension, const T &)
  {
    return extension_stiffness * extension;
  }

  /// Energy of a bond, both ends together [J].
  template <class T>
  static T bond_energy(const T &extension_stiffness, const T &extension)
  {
    return 0.5 * extension_stiffness * extension * extension;
  }
};
} // namespace ricochet
