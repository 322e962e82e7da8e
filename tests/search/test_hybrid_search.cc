// SPDX-License-Identifier: LGPL-2.1-or-later
// Searches over the points of all ranks.
#include "ricochet/search/hybrid_search.h"
#include "ricochet/search/near_points.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ricochet::tests
{
namespace
{
int rank()
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int n_ranks()
{
  int n;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

using Pairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

/// Pairs of all ranks, ascending, on every rank; what is found twice is in it twice.
Pairs gathered(const HybridSearch &search)
{
  std::vector<std::int64_t> own;
  for (const auto &pair : search.pairs())
  {
    const auto [a, b] = std::minmax(search.ids()[pair.first], search.ids()[pair.second]);
    own.push_back(a);
    own.push_back(b);
  }
  const auto all = joined(
      exchange_lists(MPI_COMM_WORLD, std::vector<std::vector<std::int64_t>>(n_ranks(), own)));
  Pairs pairs;
  for (std::size_t i = 0; i < all.size(); i += 2)
    pairs.emplace_back(all[i], all[i + 1]);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Every rank has all points; rank r hands in those whose number is r modulo the number of ranks,
/// wherever they are.
void expect_every_pair_once(const std::vector<Vector3> &points, const std::vector<char> &active,
                            const double radius, const std::string &method)
{
  std::vector<Vector3> own;
  std::vector<char> own_active;
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (static_cast<int>(i) % n_ranks() == rank())
    {
      own.push_back(points[i]);
      ids.push_back(1000000007ll * static_cast<std::int64_t>(i)); // need not be consecutive
      if (!active.empty())
        own_active.push_back(active[i]);
    }
  HybridSearch search(MPI_COMM_WORLD, method);
  search.find(own, own_active, ids, radius);

  Pairs expected;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if ((active.empty() || active[i] || active[j]) &&
          (points[i] - points[j]).squaredNorm() < radius * radius)
        expected.emplace_back(1000000007ll * i, 1000000007ll * j);
  EXPECT_EQ(gathered(search), expected);

  // What is shipped along the same ways arrives with its point.
  std::vector<double> values;
  for (const auto &x : own)
    values.push_back(x.sum());
  const auto shipped = search.distribute(values);
  ASSERT_EQ(shipped.size(), search.points().size());
  for (std::size_t i = 0; i < shipped.size(); ++i)
    EXPECT_TRUE(shipped[i] == search.points()[i].sum() || std::isnan(shipped[i]));
}

std::vector<Vector3> random_points(const int n, const Vector3 &extent, const unsigned int seed)
{
  Random random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < n; ++i)
    points.push_back(random.vector().cwiseProduct(extent));
  return points;
}

TEST(HybridSearch, FindsEveryPairOnceOnAnyNumberOfRanks)
{
  for (const char *method : {"kd-tree", "linked cells", "brute force"})
  {
    const auto points = random_points(700, {1., 0.7, 0.3}, 71);
    for (const double radius : {0.05, 0.2, 3.}) // 3: every block's halo is everything
      expect_every_pair_once(points, {}, radius, method);
    std::vector<char> active(points.size());
    for (std::size_t i = 0; i < active.size(); ++i)
      active[i] = i % 7 == 0;
    expect_every_pair_once(points, active, 0.2, method);
  }
}

TEST(HybridSearch, FindsThePairsOnTheBordersOfBlocks)
{
  // A lattice whose planes fall on the borders, and whose neighbours are a radius apart but for
  // rounding.
  std::vector<Vector3> points;
  for (int x = 0; x <= 6; ++x)
    for (int y = 0; y <= 6; ++y)
      for (int z = 0; z <= 6; ++z)
        points.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
  for (const double radius : {0.1, 0.1 * (1. + 1e-12), 0.15})
    expect_every_pair_once(points, {}, radius, "kd-tree");
}

TEST(HybridSearch, FindsThePairsOfOddClouds)
{
  expect_every_pair_once({}, {}, 1., "kd-tree");
  expect_every_pair_once({Vector3(1., 2., 3.)}, {}, 1., "kd-tree"); // most ranks have none
  expect_every_pair_once(std::vector<Vector3>(40, Vector3(1., 2., 3.)), {}, 1., "kd-tree");
  expect_every_pair_once(random_points(200, {1., 0., 0.}, 73), {}, 0.05, "kd-tree"); // a line
  auto points = random_points(200, {0.01, 0.01, 0.01}, 79);
  points.emplace_back(1e3, 0., -1e3);
  points.emplace_back(1e3, 1e-3, -1e3);
  points.emplace_back(std::nan(""), 0., 0.);
  expect_every_pair_once(points, {}, 0.003, "kd-tree");
}

TEST(NearPoints, EveryRankHearsOfAllThatOverlapsItsOwnBalls)
{
  // Balls of very different sizes in a box; the first half of each rank's own asks.
  const int n_own = 200;
  std::vector<Vector3> centres;
  std::vector<double> radii;
  Random random(83);
  for (int r = 0; r < n_ranks(); ++r)
    for (int i = 0; i < n_own; ++i)
    {
      const Vector3 x     = random.vector();
      const double radius = i % 50 == 0 ? 0.3 : 0.01 + 0.005 * random.uniform();
      centres.push_back(i == 60 ? Vector3(1e9 * x) : x); // far beyond the last numbered cell
      radii.push_back(radius);
    }
  const auto first = centres.begin() + n_own * rank();
  const auto numbers =
      balls_near_other_ranks(MPI_COMM_WORLD, {first, first + n_own},
                             {radii.begin() + n_own * rank(), radii.begin() + n_own * (rank() + 1)},
                             n_own / 2, /*cell=*/0.1);
  ASSERT_EQ(static_cast<int>(numbers.size()), n_ranks());
  EXPECT_TRUE(numbers[rank()].empty());
  std::size_t n_sent = 0;
  for (int r = 0; r < n_ranks(); ++r)
    if (r != rank())
    {
      EXPECT_TRUE(std::is_sorted(numbers[r].begin(), numbers[r].end()));
      n_sent += numbers[r].size();
      for (int i = 0; i < n_own; ++i)
      {
        const int mine = n_own * rank() + i;
        bool needed    = false;
        for (int j = n_own * r; j < n_own * r + n_own / 2; ++j)
          needed = needed || (centres[mine] - centres[j]).norm() < radii[mine] + radii[j];
        EXPECT_LE(needed, std::binary_search(numbers[r].begin(), numbers[r].end(), i))
            << "ball " << i << " of rank " << rank() << " for rank " << r;
      }
    }
  if (n_ranks() > 1)
  {
    EXPECT_GT(n_sent, 0u);
    EXPECT_LT(n_sent, std::size_t(n_own) * (n_ranks() - 1)) << "not simply all";
  }
}
} // namespace
} // namespace ricochet::tests
