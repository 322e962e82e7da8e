// SPDX-License-Identifier: LGPL-2.1-or-later
// The constants of an isotropic elastic solid, one pair from the other (Landau and Lifshitz, Theory
// of Elasticity, section 5; any table of elastic moduli). Each formula stands here once, so that
// its rounding is the same wherever it is used. Moduli in [Pa], Poisson's ratio [-].
#pragma once

namespace ricochet
{
/// K [Pa] from Young's modulus E [Pa] and Poisson's ratio nu < 1/2.
constexpr double bulk_modulus(const double E, const double nu)
{
  return E / (3. * (1. - 2. * nu));
}

/// mu [Pa] from Young's modulus E [Pa] and Poisson's ratio nu > -1.
constexpr double shear_modulus(const double E, const double nu)
{
  return E / (2. * (1. + nu));
}

/// E [Pa] from the bulk modulus K and the shear modulus mu [Pa].
constexpr double youngs_modulus(const double K, const double mu)
{
  return 9. * K * mu / (3. * K + mu);
}

/// nu [-] from the bulk modulus K and the shear modulus mu [Pa]; the same to the last bit as with
/// 6 K + 2 mu below the line, for a factor of two does not round.
constexpr double poissons_ratio(const double K, const double mu)
{
  return (3. * K - 2. * mu) / (2. * (3. * K + mu));
}
} // namespace ricochet
