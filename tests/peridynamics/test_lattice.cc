// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "support/body.h"

#include <gtest/gtest.h>

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

Lattice lattice(const int rank, const int n_ranks, const bool mirrored = false)
{
  return Lattice({Vector3::Zero(), 1e-3, {13, 7, 5}, mirrored},
                 make_stencil(1e-3, 3., InfluenceFunction::cone), rank, n_ranks);
}

TEST(Lattice, CoordinatesAndIndexAreInverse)
{
  for (const bool mirrored : {false, true})
    for (const int n_ranks : {1, 3})
      for (int rank = 0; rank < n_ranks; ++rank)
      {
        const Lattice l = lattice(rank, n_ranks, mirrored);
        for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
          if (l.owned(p))
          {
            const auto c = l.coordinates(p);
            ASSERT_EQ(l.index(c[0], c[1], c[2]), p);
            ASSERT_EQ(l.plane_of(p), c[0]);
            ASSERT_TRUE(l.exists(p));
            ASSERT_GE(c[1], 0);
          }
      }
}

TEST(Lattice, RanksOwnEveryPointOnce)
{
  for (const int n_ranks : {1, 2, 3, 6})
  {
    std::set<std::array<int, 3>> points;
    std::int64_t n = 0;
    for (int rank = 0; rank < n_ranks; ++rank)
    {
      const Lattice l = lattice(rank, n_ranks);
      n += l.n_owned_points();
      for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
        EXPECT_TRUE(!l.owned(p) || points.insert(l.coordinates(p)).second);
    }
    EXPECT_EQ(n, 13 * 7 * 5);
    EXPECT_EQ(points.size(), 13u * 7 * 5);
  }
}

TEST(Lattice, BlocksFallOnTheSamePointsForAnyNumberOfRanks)
{
  const Lattice whole = lattice(0, 1);
  for (int rank = 0; rank < 3; ++rank)
  {
    const Lattice part = lattice(rank, 3);
    EXPECT_EQ(part.plane_stride() % Lattice::block_size, 0);
    for (std::ptrdiff_t p = part.owned_begin(); p < part.owned_end(); ++p)
      if (part.owned(p))
      {
        const auto c = part.coordinates(p);
        ASSERT_EQ(whole.index(c[0], c[1], c[2]) % Lattice::block_size, p % Lattice::block_size);
      }
  }
}

TEST(Lattice, TooManyRanksAreRefusedWithTheLargestNumberThatWorks)
{
  EXPECT_NO_THROW(lattice(0, 6)); // 13 planes, the cone with m = 3 reaches 2
  try
  {
    lattice(0, 7);
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    EXPECT_NE(std::string(error.what()).find("at most 6 ranks"), std::string::npos) << error.what();
  }
}

TEST(Lattice, PlateNarrowerThanTheHorizonAtTheSymmetryPlaneIsRefused)
{
  const auto stencil = make_stencil(1e-3, 3., InfluenceFunction::cone);
  EXPECT_THROW(Lattice({Vector3::Zero(), 1e-3, {9, 1, 9}, true}, stencil, 0, 1), InputError);
  EXPECT_NO_THROW(Lattice({Vector3::Zero(), 1e-3, {9, 2, 9}, true}, stencil, 0, 1));
}

TEST(Lattice, BoxHasTheBondsOfItsOffsets)
{
  BodySample sample;
  sample.n        = {7, 6, 7};
  const auto body = make_body(sample);
  const auto &l   = body->lattice();
  // Bonds of a box: for each offset the number of points whose neighbour lies inside.
  double expected = 0.;
  for (const auto &o : l.stencil().offsets)
    expected += double(7 - std::abs(o.x)) * (6 - std::abs(o.y)) * (7 - std::abs(o.z));
  EXPECT_EQ(body->count_bonds(), expected);
}

TEST(Lattice, MirroredHalfHasHalfTheBonds)
{
  BodySample half, full;
  half.n        = {7, 5, 7};
  half.mirror_y = true;
  full.n        = {7, 10, 7};
  EXPECT_EQ(make_body(half)->count_bonds(), 0.5 * make_body(full)->count_bonds());
}

TEST(PeridynamicBody, LawThatFixesPoissonsRatioRefusesOtherModuli)
{
  BodySample sample;
  sample.family.law = bond_law_samples[1];
  sample.family.law.shear_modulus *= 1.1;
  EXPECT_THROW(make_body(sample), InputError);
}

TEST(PeridynamicBody, MissingInstructionSetIsRefused)
{
  BodySample sample;
  sample.instruction_set = "abacus";
  EXPECT_THROW(make_body(sample), InputError);
}
} // namespace
} // namespace ricochet::tests
