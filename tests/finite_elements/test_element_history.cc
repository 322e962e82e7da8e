// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_elements/element_history.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr int n_branches = 2;

ElementHistory::Memory some_memory(const int n_points)
{
  ElementHistory::Memory memory;
  memory.dissipated = 7.;
  for (int point = 0; point < n_points; ++point)
  {
    auto &values = memory.points.emplace_back();
    for (int i = 0; i < 6 * (1 + n_branches); ++i)
      values.push_back(100. * point + i);
  }
  return memory;
}

TEST(ElementHistory, GivesBackWhatItWasGiven)
{
  for (const int n_points : {1, 8})
  {
    ElementHistory history(11, n_points, n_branches); // two blocks, the second not full
    const auto memory = some_memory(n_points);
    history.restore(9, memory);
    EXPECT_EQ(history.memory(9).points, memory.points);
    EXPECT_EQ(history.memory(9).dissipated, 7.);
    for (const int other : {0, 1, 8, 10})
    {
      EXPECT_EQ(history.strain(other), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
      EXPECT_EQ(history.dissipated()[other], 0.);
    }
  }
}

TEST(ElementHistory, LiesAsTheKernelReadsIt)
{
  ElementHistory history(11, 8, n_branches);
  history.restore(9, some_memory(8));
  // Per block, Gauss point and branch: rows of eight lanes (HexRelaxation).
  for (int point = 0; point < 8; ++point)
    for (int i = 0; i < 6 * (1 + n_branches); ++i)
      EXPECT_EQ(history.values()[((8 + point) * 6 * (1 + n_branches) + i) * 8 + 1],
                100. * point + i);
}

TEST(ElementHistory, SpreadsOnePointAndTakesTheMeanOfEight)
{
  ElementHistory eight(1, 8, n_branches), one(1, 1, n_branches);
  eight.restore(0, some_memory(1));
  for (const auto &point : eight.memory(0).points)
    EXPECT_EQ(point, some_memory(1).points[0]);
  one.restore(0, some_memory(8));
  for (int i = 0; i < 6 * (1 + n_branches); ++i)
    EXPECT_DOUBLE_EQ(one.memory(0).points[0][i], 350. + i);
}

TEST(ElementHistory, KnowsStrainAndBackStrain)
{
  ElementHistory history(1, 1, n_branches);
  history.restore(0, some_memory(1));
  Eigen::Matrix3d E; // half of 0, 1, 2, 3, 4, 5 in the order 11, 22, 33, 23, 13, 12
  E << 0., 2.5, 2., 2.5, 0.5, 1.5, 2., 1.5, 1.;
  EXPECT_EQ(history.strain(0), E);
  // Branch 1 holds 2 (E - E_b) = 12 ... 17, so that 2 E_b is -12 throughout.
  EXPECT_EQ(history.back_strain(0, 1), Eigen::Matrix3d(Eigen::Matrix3d::Constant(-6.)));
}
} // namespace
} // namespace ricochet::tests
