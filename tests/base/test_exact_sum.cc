// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exact_sum.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ricochet::tests
{
namespace
{
double sum_of(const std::vector<double> &terms)
{
  ExactSum sum;
  for (const double term : terms)
    sum.add(term);
  return sum.value();
}

/// Of all sizes and both signs.
std::vector<double> terms(const int n)
{
  Random random(5);
  std::vector<double> list;
  for (int i = 0; i < n; ++i)
    list.push_back(std::ldexp(random.uniform(), static_cast<int>(1000. * random.uniform())));
  return list;
}

TEST(ExactSum, OfOneTermIsTheTerm)
{
  const double smallest = std::numeric_limits<double>::denorm_min(),
               largest  = std::numeric_limits<double>::max();
  for (const double x :
       {0., 1., -1., 0.1, -1e-300, 1e300, smallest, -3. * smallest, largest, -largest,
        std::numeric_limits<double>::min(), 0x1.fffffffffffffp-960, -0x1.8p-1000})
    EXPECT_EQ(sum_of({x}), x);
}

TEST(ExactSum, LosesNothing)
{
  EXPECT_EQ(sum_of({1e300, 1e-300, -1e300}), 1e-300);
  EXPECT_EQ(sum_of({1., 1e-20, -1.}), 1e-20);
  EXPECT_EQ(sum_of({0.1, 0.2, -0.3}), 0x1p-55); // of the doubles, exactly 2^-55
  auto list           = terms(1000);
  const std::size_t n = list.size();
  for (std::size_t i = 0; i < n; ++i)
    list.push_back(-list[(7 * i) % n]); // 7 and 1000 have no common divisor
  EXPECT_EQ(sum_of(list), 0.);
}

TEST(ExactSum, RoundsToTheNearestDoubleAndTiesToEven)
{
  const double half = 0x1p-53; // of the last place of 1
  EXPECT_EQ(sum_of({1., half}), 1.);
  EXPECT_EQ(sum_of({1., half, 1e-300}), 1. + 2. * half);
  EXPECT_EQ(sum_of({1., half, -1e-300}), 1.);
  EXPECT_EQ(sum_of({1. + 2. * half, half}), 1. + 4. * half);
  EXPECT_EQ(sum_of({-1., -half, -1e-300}), -1. - 2. * half);
}

TEST(ExactSum, DoesNotDependOnTheOrder)
{
  auto list         = terms(2000);
  const double here = sum_of(list);
  std::reverse(list.begin(), list.end());
  EXPECT_EQ(sum_of(list), here);
  std::sort(list.begin(), list.end());
  EXPECT_EQ(sum_of(list), here);
}

TEST(ExactSum, SaysWhatIsNotFinite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sum_of({1., infinity}), infinity);
  EXPECT_TRUE(std::isnan(sum_of({infinity, -infinity})));
  EXPECT_TRUE(std::isnan(sum_of({std::nan(""), 1.})));
}

TEST(ExactSum, IsTheSameHoweverTermsLieOnRanks)
{
  const auto list = terms(1000);
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  std::array<ExactSum, 2> mine;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (static_cast<int>(i * i % n_ranks) == rank)
    {
      mine[0].add(list[i]);
      mine[1].add(1e-3 * std::abs(list[i]));
    }
  std::array<ExactSum, 2> all;
  for (const double term : list)
  {
    all[0].add(term);
    all[1].add(1e-3 * std::abs(term));
  }
  const auto found = totals(MPI_COMM_WORLD, mine);
  EXPECT_EQ(found[0], all[0].value());
  EXPECT_EQ(found[1], all[1].value());
}
} // namespace
} // namespace ricochet::tests
