// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/cutouts.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(Cutouts, AHoleIsACylinderAndItsBorderIsMaterial)
{
  const Cutouts::Hole hole{10., -2., 6.};
  for (const double depth : {-1., 0., 100.})
  {
    EXPECT_TRUE(removes(hole, {10., -2., depth}));
    EXPECT_TRUE(removes(hole, {12.1, 0.1, depth}));
    EXPECT_FALSE(removes(hole, {12.2, 0.2, depth}));
    EXPECT_FALSE(removes(hole, {13., -2., depth}));
    EXPECT_FALSE(removes(hole, {10., -5., depth}));
  }
  EXPECT_EQ(column_of(hole), (std::array<double, 4>{7., 13., -5., 1.}));
  EXPECT_FALSE(is_symmetric(hole));
  EXPECT_TRUE(is_symmetric(Cutouts::Hole{10., 0., 6.}));
}

TEST(Cutouts, ANotchIsABoxAndItsBorderIsMaterial)
{
  const Cutouts::Notch notch{1., 3., -4., 5., 0., 2.};
  EXPECT_TRUE(removes(notch, {1.1, 4.9, 0.1}));
  for (const Vector3 &kept : {Vector3(1., 0., 1.), Vector3(3., 0., 1.), Vector3(2., -4., 1.),
                              Vector3(2., 5., 1.), Vector3(2., 0., 0.), Vector3(2., 0., 2.)})
    EXPECT_FALSE(removes(notch, kept)) << kept.transpose();
  EXPECT_EQ(column_of(notch), (std::array<double, 4>{1., 3., -4., 5.}));
  EXPECT_FALSE(is_symmetric(notch));
  EXPECT_TRUE(is_symmetric(Cutouts::Notch{1., 3., -4., 4., 0., 2.}));
}

TEST(Cutouts, ACrackSeversTheLinesThroughItsRectangle)
{
  const Cutouts::Crack across{0, 5., -2., 2., 1., 3.};
  EXPECT_TRUE(severs(across, {4., 0., 2.}, {6., 0., 2.}));
  EXPECT_TRUE(severs(across, {6., 0., 2.}, {4., 0., 2.}));
  EXPECT_FALSE(severs(across, {4., 0., 2.}, {4.5, 0., 2.})) << "on one side";
  // Both ends are beside the rectangle, the line is not; and the other way round.
  EXPECT_TRUE(severs(across, {4., -2.5, 2.}, {8., 7.5, 2.}));
  EXPECT_FALSE(severs(across, {4., 0., 2.}, {6., 6., 2.}));
  EXPECT_FALSE(severs(across, {4., 0., 2.}, {6., 0., 6.}));
  EXPECT_TRUE(severs(across, {4., 2., 3.}, {6., 2., 3.})) << "along the border";

  const Cutouts::Crack along{1, 5., -2., 2., 1., 3.};
  EXPECT_TRUE(severs(along, {0., 4., 2.}, {0., 6., 2.}));
  EXPECT_FALSE(severs(along, {3., 4., 2.}, {3., 6., 2.}));
  EXPECT_EQ(column_of(across), (std::array<double, 4>{5., 5., -2., 2.}));
  EXPECT_EQ(column_of(along), (std::array<double, 4>{-2., 2., 5., 5.}));
  EXPECT_TRUE(is_symmetric(across));
  EXPECT_FALSE(is_symmetric(along));
  EXPECT_TRUE(is_symmetric(Cutouts::Crack{1, 0., 1., 2., 0., 1.}));
}

TEST(Cutouts, APointInThePlaneOfACrackIsOnItsFarSide)
{
  const Cutouts::Crack crack{0, 5., -2., 2., 0., 3.};
  EXPECT_TRUE(severs(crack, {4., 0., 1.}, {5., 0., 1.}));
  EXPECT_FALSE(severs(crack, {5., 0., 1.}, {6., 0., 1.}));
}

TEST(Cutouts, AllTogether)
{
  Cutouts cutouts;
  EXPECT_TRUE(cutouts.empty());
  cutouts.holes   = {{10., 0., 6.}};
  cutouts.notches = {{20., 22., -1., 1., 0., 2.}};
  cutouts.cracks  = {{0, 30., -1., 1., 0., 2.}};
  EXPECT_FALSE(cutouts.empty());
  EXPECT_TRUE(cutouts.removes({10., 0., 5.}));
  EXPECT_TRUE(cutouts.removes({21., 0., 1.}));
  EXPECT_FALSE(cutouts.removes({30., 0., 1.}));
  EXPECT_TRUE(cutouts.severs({29., 0., 1.}, {31., 0., 1.}));
  EXPECT_FALSE(cutouts.severs({9., 0., 1.}, {11., 0., 1.}));
  EXPECT_EQ(cutouts.columns().size(), 3u);
}
} // namespace
} // namespace ricochet::tests
