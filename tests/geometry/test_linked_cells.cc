// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random.h"
#include "ricochet/geometry/linked_cells.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::tests
{
namespace
{
using Pairs = std::set<std::pair<int, int>>;

/// All pairs by brute force; `with_active`: only those with an active point.
Pairs all_pairs(const std::vector<Vector3> &points, const std::vector<char> &active,
                const double radius, const bool with_active)
{
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(points.size()); ++j)
      if ((!with_active || active[i] || active[j]) &&
          (points[i] - points[j]).squaredNorm() < radius * radius)
        pairs.insert({i, j});
  return pairs;
}

void expect_brute_force(const std::vector<Vector3> &points, const std::vector<char> &active,
                        const double radius)
{
  Pairs found;
  int n_visits = 0;
  LinkedCells(points, active, radius)
      .for_each_pair(
          [&](const int i, const int j)
          {
            found.insert({std::min(i, j), std::max(i, j)});
            ++n_visits;
          });
  EXPECT_EQ(n_visits, static_cast<int>(found.size())) << "each pair once";
  // Every pair with an active point is found; a pair of two idle ones may be, if an active one
  // shares their cell.
  const Pairs wanted  = all_pairs(points, active, radius, true),
              allowed = all_pairs(points, active, radius, false);
  for (const auto &pair : wanted)
    EXPECT_TRUE(found.count(pair)) << pair.first << " " << pair.second;
  for (const auto &pair : found)
    EXPECT_TRUE(allowed.count(pair)) << pair.first << " " << pair.second;
}

std::vector<Vector3> random_points(const int n, const double extent, const unsigned int seed)
{
  Random random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < n; ++i)
    points.push_back(extent * random.vector());
  return points;
}

TEST(LinkedCells, FindThePairsOfRandomPoints)
{
  for (const double radius : {0.05, 0.3, 1., 5.})
    expect_brute_force(random_points(400, 1., 23), std::vector<char>(400, 1), radius);
}

TEST(LinkedCells, FindThePairsOfClustersAndFarFlungPoints)
{
  auto points = random_points(200, 0.02, 29); // about the origin, where cell numbers change sign
  Random random(31);
  for (int cluster = 0; cluster < 20; ++cluster)
  {
    const Vector3 centre = 50. * random.vector();
    for (int i = 0; i < 15; ++i)
      points.push_back(centre + 0.02 * random.vector());
  }
  points.push_back(
      {9e4, -9e4, 9e4}); // 9e5 cells away, the two million cells of an axis are 2e5 wide
  points.push_back({9e4, -9e4, 9e4 + 0.05});
  expect_brute_force(points, std::vector<char>(points.size(), 1), 0.1);
}

TEST(LinkedCells, FindThePairsOfALatticeWhosePointsLieOnCellBorders)
{
  std::vector<Vector3> points;
  for (int x = -3; x < 4; ++x)
    for (int y = -3; y < 4; ++y)
      for (int z = -3; z < 4; ++z)
        points.push_back({double(x), double(y), double(z)});
  expect_brute_force(points, std::vector<char>(points.size(), 1),
                     1.); // none: the distance must be smaller
  expect_brute_force(points, std::vector<char>(points.size(), 1), 1.001); // 6 neighbours
  expect_brute_force(points, std::vector<char>(points.size(), 1), 2.);
}

TEST(LinkedCells, LeaveOutPairsOfIdlePoints)
{
  const auto points = random_points(500, 1., 37);
  std::vector<char> active(points.size());
  for (std::size_t i = 0; i < active.size(); ++i)
    active[i] = i % 50 == 0;
  expect_brute_force(points, active, 0.15);

  int n_visits = 0;
  LinkedCells(points, std::vector<char>(points.size(), 0), 0.15)
      .for_each_pair([&](int, int) { ++n_visits; });
  EXPECT_EQ(n_visits, 0);
  LinkedCells({}, {}, 1.).for_each_pair([&](int, int) { ++n_visits; });
  EXPECT_EQ(n_visits, 0);
}
} // namespace
} // namespace ricochet::tests
