// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::tests
{
namespace
{
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
} // namespace
} // namespace ricochet::tests
