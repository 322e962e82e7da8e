// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/peridynamics/stencil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ricochet::tests
{
namespace
{
TEST(Stencil, HoldsHalfOfAllOffsetsWithinTheHorizonOnce)
{
  for (const double ratio : {1., 1.5, 2., 3., 3.01, 4.5})
  {
    const auto stencil = make_stencil(0.5, ratio, InfluenceFunction::constant);
    std::set<std::array<int, 3>> both;
    int expected = 0, reach = 0;
    for (const auto &o : stencil.offsets)
    {
      EXPECT_TRUE(both.insert({o.x, o.y, o.z}).second);
      EXPECT_TRUE(both.insert({-o.x, -o.y, -o.z}).second);
      EXPECT_DOUBLE_EQ(o.length, 0.5 * std::sqrt(o.x * o.x + o.y * o.y + o.z * o.z));
      EXPECT_EQ(o.omega, 1.);
      reach = std::max({reach, std::abs(o.x), std::abs(o.y), std::abs(o.z)});
    }
    const int n = 5;
    for (int x = -n; x <= n; ++x)
      for (int y = -n; y <= n; ++y)
        for (int z = -n; z <= n; ++z)
          expected += (x || y || z) && x * x + y * y + z * z <= ratio * ratio + 1e-9;
    EXPECT_EQ(static_cast<int>(both.size()), expected) << ratio;
    EXPECT_EQ(stencil.reach, reach);
  }
}

TEST(Stencil, BondsWithoutWeightAreLeftOut)
{
  // The cone vanishes at the horizon: 92 bonds of 122.
  EXPECT_EQ(make_stencil(1., 3., InfluenceFunction::cone).offsets.size(), 46u);
  EXPECT_EQ(make_stencil(1., 3., InfluenceFunction::constant).offsets.size(), 61u);
}

TEST(Stencil, HorizonRatioOutsideItsRangeIsRefused)
{
  for (const double ratio : {0.5, 9., std::nan("")})
    EXPECT_THROW(make_stencil(1., ratio, InfluenceFunction::cone), InputError);
}

TEST(Stencil, FamilyOfNearestNeighboursHasTheSumsOfSixBonds)
{
  // m = sum omega |xi|^2 V, and the same with |xi|: six neighbours at the distance dx.
  const double dx = 0.5e-3, V = dx * dx * dx;
  const auto family = family_constants(make_stencil(dx, 1., InfluenceFunction::constant), 5e9, 2e9);
  EXPECT_NEAR(family.volume, V, 1e-15 * V);
  EXPECT_NEAR(family.weighted_volume, 6. * dx * dx * V, 1e-15 * 6. * dx * dx * V);
  EXPECT_NEAR(family.first_moment, 6. * dx * V, 1e-15 * 6. * dx * V);
}

TEST(Stencil, CrackThroughNearestNeighboursCutsOneBondPerSpacingSquared)
{
  // Two ends at theta = 1 each: half the tension at unit stretch times the length, per dx^2.
  const double dx    = 1e-3;
  const auto stencil = make_stencil(dx, 1., InfluenceFunction::constant);
  for (const char *name : {"linear peridynamic solid", "microelastic brittle"})
  {
    const auto &law       = bond_law(name);
    const auto c          = law.bond(family_constants(stencil, 5e9, 3e9), dx, 1.);
    const double expected = 0.5 * law.tension(c, dx, 2.) * dx / (dx * dx);
    EXPECT_GT(expected, 0.);
    EXPECT_NEAR(fracture_energy_per_squared_stretch(stencil, law, 5e9, 3e9) / expected, 1., 1e-14)
        << name;
  }
}

TEST(Stencil, LatticeIsAsAnisotropicAsItsEnergyUnderUniformStrain)
{
  // With theta = tr(strain): W = (K - 5 mu/3) theta^2/2 + (15 mu/m)/2 sum omega e^2 V (Silling et
  // al. 2007), which is C11/2 under the strain 11, C11 + C12 under 11 and 22, C44/2 under 12.
  const double K = 5.9e9, mu = 2.258e9;
  for (const auto function : {InfluenceFunction::cone, InfluenceFunction::constant})
    for (const double ratio : {3., 4.})
    {
      const auto stencil = make_stencil(1e-3, ratio, function);
      const auto family  = family_constants(stencil, K, mu);
      const auto energy  = [&](const double e11, const double e22, const double twice_e12)
      {
        const double theta = e11 + e22;
        double sum         = 0.;
        for (const auto &o : stencil.offsets)
        {
          const double x = o.x * 1e-3, y = o.y * 1e-3;
          const double e = (x * x * e11 + y * y * e22 + x * y * twice_e12) / o.length;
          sum += 2. * o.omega * e * e * family.volume;
        }
        return 0.5 * (K - 5. / 3. * mu) * theta * theta +
               0.5 * 15. * mu / family.weighted_volume * sum;
      };
      const double c11 = 2. * energy(1., 0., 0.), c12 = energy(1., 1., 0.) - c11,
                   c44 = 2. * energy(0., 0., 1.);
      const auto found = lattice_anisotropy(stencil, bond_law("linear peridynamic solid"), K, mu);
      EXPECT_NEAR(found.tetragonal, 0.5 * (c11 - c12) / mu, 1e-12);
      EXPECT_NEAR(found.diagonal, c44 / mu, 1e-12);
      // The bulk modulus is the one given.
      EXPECT_NEAR((c11 + 2. * c12) / 3., K, 1e-12 * K);
    }
}

TEST(Stencil, ConeOfThreeSpacingsIsNearlyIsotropicAConstantIsNot)
{
  const auto anisotropy = [](const InfluenceFunction function)
  {
    return lattice_anisotropy(make_stencil(1., 3., function), bond_law("linear peridynamic solid"),
                              5.9e9, 2.258e9);
  };
  EXPECT_NEAR(anisotropy(InfluenceFunction::cone).tetragonal, 1., 4e-3);
  EXPECT_NEAR(anisotropy(InfluenceFunction::cone).diagonal, 1., 4e-3);
  EXPECT_GT(anisotropy(InfluenceFunction::constant).diagonal, 1.1);
}
} // namespace
} // namespace ricochet::tests
