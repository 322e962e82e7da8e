// SPDX-License-Identifier: LGPL-2.1-or-later
// Every method, and every instruction set of the two with their own loops, against the double loop.
#include "ricochet/base/exceptions.h"
#include "ricochet/search/pair_search.h"
#include "search/cell_grid.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ricochet::tests
{
namespace
{
using Pairs = std::vector<std::pair<int, int>>; // ascending; one that is found twice is in it twice

struct Method
{
  std::string name;
  std::function<std::unique_ptr<PairSearch>()> make;
};

void PrintTo(const Method &method, std::ostream *out)
{
  *out << method.name;
}

std::vector<Method> all_methods()
{
  std::vector<Method> methods;
  for (const auto &search : pair_searches())
    methods.push_back({search.name, search.make});
  for (const char *set : {"avx512", "avx2", "baseline"})
    try
    {
      pair_loops(set);
      methods.push_back(
          {std::string("linked cells ") + set, [set] { return make_linked_cells(set); }});
      methods.push_back(
          {std::string("brute force ") + set, [set] { return make_brute_force(set); }});
    }
    catch (const InputError &)
    {
      // Not on this processor.
    }
  return methods;
}

class PairSearches : public testing::TestWithParam<Method>
{
protected:
  Pairs found(const std::vector<Vector3> &points, const std::vector<char> &active,
              const double radius, const SearchShare share = {},
              const Families &families = {}) const
  {
    std::vector<PointPair> found{{7, 7}}; // must be overwritten
    GetParam().make()->find(points, active, radius, found, share, families);
    Pairs pairs;
    for (const auto &pair : found)
      pairs.push_back(std::minmax(pair.first, pair.second));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  static Pairs expected(const std::vector<Vector3> &points, const std::vector<char> &active,
                        const double radius)
  {
    Pairs pairs;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(points.size()); ++j)
        if ((active.empty() || active[i] || active[j]) &&
            (points[i] - points[j]).squaredNorm() < radius * radius)
          pairs.emplace_back(i, j);
    return pairs;
  }

  /// With all points active, with every third one, with few and with none; returns the number of
  /// pairs of all.
  std::size_t expect_all_pairs(const std::vector<Vector3> &points, const double radius) const
  {
    std::vector<char> third(points.size()), few(points.size(), 0), none(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      third[i] = i % 3 == 0;
      few[i]   = i % 41 == 7;
    }
    for (const auto &active : {std::vector<char>(), third, few, none})
      EXPECT_EQ(found(points, active, radius), expected(points, active, radius));
    EXPECT_TRUE(found(points, none, radius).empty());
    return expected(points, {}, radius).size();
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, PairSearches, testing::ValuesIn(all_methods()),
                         [](const auto &info)
                         {
                           std::string name = info.param.name;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); },
                               '_');
                           return name;
                         });

std::vector<Vector3> random_points(const int n, const double extent, const unsigned int seed)
{
  Random random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < n; ++i)
    points.push_back(extent * random.vector());
  return points;
}

std::vector<Vector3> lattice_points(const int n)
{
  std::vector<Vector3> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        points.emplace_back(x - n / 2, y - n / 2, z - n / 2);
  return points;
}

TEST_P(PairSearches, FindThePairsOfRandomPoints)
{
  // From hardly any pair to all of them.
  for (const double radius : {0.05, 0.3, 1., 5.})
    EXPECT_GT(expect_all_pairs(random_points(600, 1., 23), radius), 0u) << radius;
}

TEST_P(PairSearches, FindThePairsOfALatticeWhosePointsLieOnCellBorders)
{
  EXPECT_EQ(expect_all_pairs(lattice_points(8), 1.), 0u); // a pair a radius apart is none
  EXPECT_EQ(expect_all_pairs(lattice_points(8), std::nextafter(1., 2.)), 3u * 8 * 8 * 7);
  EXPECT_GT(expect_all_pairs(lattice_points(8), 2.1), 3u * 8 * 8 * 7);
}

TEST_P(PairSearches, FindThePairsOfClustersAndFarFlungPoints)
{
  auto points = random_points(200, 2e-3, 29); // about the origin, where coordinates change sign
  Random random(31);
  for (int cluster = 0; cluster < 25; ++cluster)
  {
    const Vector3 centre = 0.3 * random.vector();
    for (int i = 0; i < 12; ++i)
      points.push_back(centre + 2e-3 * random.vector());
  }
  const std::size_t n_near = expected(points, {}, 2e-3).size();
  // Outliers, two of them a pair; cells of 2 mm would be 1e17.
  for (const auto &far : {Vector3(1e3, -1e3, 1e3), Vector3(1e3, -1e3, 1e3 + 1e-3),
                          Vector3(-1e3, 0., 0.), Vector3(0., 0., 1e3)})
    points.push_back(far);
  EXPECT_EQ(expect_all_pairs(points, 2e-3), n_near + 1);
}

TEST_P(PairSearches, DecideInDoublePrecisionWhatIsARadiusApart)
{
  // Single precision cannot tell these distances from the radius, neither near the lowest corner
  // nor far from it.
  Random random(41);
  std::vector<Vector3> points;
  for (int i = 0; i < 400; ++i)
  {
    const Vector3 x = 0.1 * random.vector();
    points.push_back(x);
    points.push_back(x + 3e-3 * (1. + 1e-11 * random.uniform()) * random.vector().normalized());
  }
  const std::size_t n_pairs = expect_all_pairs(points, 3e-3);
  EXPECT_GT(n_pairs, 150u);
  EXPECT_LT(n_pairs, 300u);
}

TEST_P(PairSearches, FindThePairsAcrossTheSeamOfTheGrid)
{
  // Long thin clouds with outliers: every axis wraps around in one of them, and neighbours lie on
  // either side of the seam.
  for (int axis = 0; axis < 3; ++axis)
  {
    Random random(43 + axis);
    std::vector<Vector3> points;
    for (int i = 0; i < 700; ++i)
    {
      Vector3 x = 0.8 * random.vector();
      x[axis] *= 300.;
      points.push_back(x);
    }
    for (const double far : {-1e5, 1e5})
      points.push_back(far * Vector3::Ones());
    EXPECT_GT(expect_all_pairs(points, 1.), 100u);
  }
}

TEST_P(PairSearches, DoNotTakePointsPeriodsApartForNeighbours)
{
  // The grid wraps around after four cells of 1.001: all but the corners share one cell and their
  // place in it, from one period to as many as the numbers of periods can hold, and one more.
  std::vector<Vector3> points{{0., 0., 0.}, {1e6, 1e6, 1e6}};
  for (const double n : {0., 1., 2., 1015., 1016., 1023., 1024., 1025.})
    for (int axis = 0; axis < 3; ++axis)
      points.push_back(Vector3(0.5, 0.5, 0.5) + 4. * 1.001 * n * Vector3::Unit(axis));
  // Three of them coincide, near the first corner.
  EXPECT_EQ(expect_all_pairs(points, 1.), 3u + 3u);
}

TEST_P(PairSearches, FindThePairsOfCoincidentPoints)
{
  std::vector<Vector3> points(300, Vector3(1., 2., 3.));
  EXPECT_EQ(expect_all_pairs(points, 1e-6), 300u * 299 / 2);
  for (int i = 0; i < 100; ++i)
    points[i] += Vector3(0.5e-6 * i, 0., 0.);
  EXPECT_GT(expect_all_pairs(points, 1e-6), 200u * 199 / 2);
}

TEST_P(PairSearches, FindNothingAmongNoneOrOne)
{
  EXPECT_TRUE(found({}, {}, 1.).empty());
  EXPECT_TRUE(found({}, std::vector<char>(), 1e-3).empty());
  EXPECT_TRUE(found({Vector3(1., 2., 3.)}, {}, 1.).empty());
  EXPECT_EQ(found({Vector3(1., 2., 3.), Vector3(1., 2., 3.5)}, {}, 1.), (Pairs{{0, 1}}));
}

TEST_P(PairSearches, LeaveOutWhatIsNotANumber)
{
  // A run that has gone wrong must reach its error message.
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               inf = std::numeric_limits<double>::infinity();
  auto points      = random_points(100, 1., 47);
  points[3].x()    = nan;
  points[40]       = {nan, nan, nan};
  points[41].y()   = inf;
  points[42].z()   = -inf;
  EXPECT_GT(expect_all_pairs(points, 0.5), 0u);
  EXPECT_TRUE(found({points[40], points[40]}, {}, 1.).empty());
}

TEST_P(PairSearches, SharesTogetherFindEveryPairOnce)
{
  const auto points = random_points(500, 1., 53);
  std::vector<char> active(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    active[i] = i % 5 != 0;
  for (const int n_parts : {2, 3, 7})
  {
    Pairs all;
    for (int part = 0; part < n_parts; ++part)
    {
      const auto pairs = found(points, active, 0.3, {part, n_parts});
      all.insert(all.end(), pairs.begin(), pairs.end());
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, expected(points, active, 0.3)) << n_parts;
  }
}

TEST_P(PairSearches, LeaveOutPairsWithinAFamily)
{
  // Points of a lattice, shaken until many that were far apart are near, and a second body beside
  // it. What is left are the pairs further apart in the lattice than the family reaches.
  Random random(71);
  std::vector<Vector3> points;
  std::vector<char> active;
  Families families;
  families.squared_range = 5.f;
  for (const int body : {0, 1})
    for (int x = 0; x < 9; ++x)
      for (int y = -4; y < 5; ++y)
        for (int z = 0; z < 9; ++z)
        {
          points.push_back(Vector3(x, y, z) + 1.5 * random.vector());
          active.push_back(random.uniform() > -0.5);
          families.place.push_back({1e6f + 100.f * body + x, 1.f * y, 1.f * z});
        }
  const double radius = 1.8;
  for (const auto &chosen : {std::vector<char>(), active})
  {
    Pairs others;
    for (const auto &[a, b] : expected(points, chosen, radius))
    {
      const auto &p = families.place[a], &q = families.place[b];
      if (std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2) > 5.)
        others.emplace_back(a, b);
    }
    EXPECT_GT(others.size(), 1000u);
    EXPECT_LT(others.size(), expected(points, chosen, radius).size() - 1000u);
    EXPECT_EQ(found(points, chosen, radius, {}, families), others);
  }
}

TEST_P(PairSearches, CountIsTheExpectedOneOfUniformPoints)
{
  // 30,000 points in a cube of 100 mm, 3 mm: 4.92e4 pairs by the distribution of distances in a
  // cube.
  std::vector<PointPair> pairs;
  GetParam().make()->find(random_points(30000, 50e-3, 59), {}, 3e-3, pairs);
  const double r = 0.03, probability = 4. / 3. * M_PI * r * r * r - 1.5 * M_PI * std::pow(r, 4) +
                                       1.6 * std::pow(r, 5) - std::pow(r, 6) / 6.;
  const double expectation = 0.5 * 30000. * 29999. * probability;
  EXPECT_NEAR(expectation, 4.92e4, 0.005e4);
  EXPECT_NEAR(static_cast<double>(pairs.size()), expectation, 5. * std::sqrt(expectation));
}

TEST(PairSearch, UnknownNameShowsTheMenu)
{
  try
  {
    make_pair_search("octree");
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    for (const char *part : {"octree", "linked cells", "kd-tree", "brute force"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_THROW(pair_loops("abacus"), InputError);
}

TEST(CellGrid, NumberOfCellsDoesNotDependOnTheExtent)
{
  auto points = random_points(1000, 0.1, 61);
  points.push_back({1e3, 1e3, -1e3});
  points.push_back({-1e9, 0., 0.});
  EXPECT_LE(CellGrid(points, {}, 1e-3).n_cells(), 4 * 1002);
  EXPECT_EQ(CellGrid(points, {}, 1e-3).order().size(), points.size());
}

TEST(CellGrid, PointsFarFromActiveOnesAreLeftOut)
{
  const auto points = random_points(2000, 1., 67);
  std::vector<char> active(points.size(), 0);
  active[0]          = 1;
  const auto order   = CellGrid(points, active, 0.1).order();
  const auto is_kept = [&](const int i) { return std::count(order.begin(), order.end(), i) == 1; };
  EXPECT_LT(order.size(), points.size() / 10);
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    EXPECT_TRUE(is_kept(i) || (points[i] - points[0]).norm() >= 0.1);
}
} // namespace
} // namespace ricochet::tests
