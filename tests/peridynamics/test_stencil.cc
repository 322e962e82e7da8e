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
} // namespace
} // namespace ricochet::tests
