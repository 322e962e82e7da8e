// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/observed_order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
// Of bisection and powers, many times rounding.
constexpr double rounding = 1e-9;

/// 100 + 7 h^p on these grids.
std::vector<GridResult> results(const double p, const std::vector<double> &sizes)
{
  std::vector<GridResult> grids;
  for (const double h : sizes)
    grids.push_back({h, 100. + 7. * std::pow(h, p)});
  return grids;
}

TEST(ObservedOrder, IsThatOfAPowerAlsoOnUnequalRatios)
{
  for (const double p : {0.5, 1., 2., 3.7})
  {
    const auto found = observed_order(results(p, {0.75, 2., 1.}));
    ASSERT_TRUE(found.order);
    EXPECT_NEAR(*found.order, p, rounding);
    EXPECT_NEAR(*found.limit, 100., rounding);
    EXPECT_FALSE(found.uncertainty); // three grids say nothing of it
  }
}

TEST(ObservedOrder, FourGridsTellItsUncertainty)
{
  const auto exact = observed_order(results(2., {4., 2., 1., 0.5}));
  EXPECT_NEAR(exact.uncertainty.value(), 0., rounding);
  // 100 + h + h^2: between 1 and 2; by hand (2 + 12)/(1 + 3) = 2^p and (1 + 3)/(0.5 + 0.75) = 2^p.
  std::vector<GridResult> mixed;
  for (const double h : {4., 2., 1., 0.5})
    mixed.push_back({h, 100. + h + h * h});
  const auto found = observed_order(mixed);
  EXPECT_NEAR(found.order.value(), std::log2(4. / 1.25), rounding);
  EXPECT_NEAR(found.uncertainty.value(), 0.5 * (std::log2(3.5) - std::log2(3.2)), rounding);
}

TEST(ObservedOrder, StandardErrorsWidenIt)
{
  auto grids = results(1., {4., 2., 1.}); // 128, 114, 107
  for (auto &grid : grids)
    grid.error = 0.1;
  const auto found = observed_order(grids);
  // d p = d ln((q1 - q2)/(q2 - q3)) / ln 2: 0.1/14, 0.1 (1/14 + 1/7) and 0.1/7, in squares.
  const double expected =
      0.1 / std::log(2.) *
      std::sqrt(1. / 14. / 14. + std::pow(1. / 14. + 1. / 7., 2) + 1. / 7. / 7.);
  // Of second order in the change of the ratio, which is 2 % at most.
  EXPECT_NEAR(found.uncertainty.value(), expected, 0.02 * expected);
  for (auto &grid : grids)
    grid.error = 3.; // 2 sqrt(18) > 7
  EXPECT_EQ(observed_order(grids).why_none, "differences are lost in the scatter of the runs");
}

TEST(ObservedOrder, IsNoneWhereThereIsNone)
{
  const auto reason = [](const std::vector<double> &values)
  {
    std::vector<GridResult> grids;
    double h = 8.;
    for (const double value : values)
      grids.push_back({h /= 2., value});
    const auto found = observed_order(grids);
    EXPECT_FALSE(found.order);
    EXPECT_FALSE(found.limit);
    return found.why_none;
  };
  EXPECT_EQ(reason({1., 2.}), "three grids are needed");
  EXPECT_EQ(reason({1., 2., 1.5}), "values go to and fro");
  EXPECT_EQ(reason({1., 2., 2.}), "two grids agree to the last digit");
  EXPECT_NE(reason({1., 2., 3.5}).find("do not fall"), std::string::npos);
  EXPECT_NE(reason({1., 2., 3.}).find("do not fall"), std::string::npos); // order 0
  EXPECT_EQ(reason({1., 2., 1.5, 1.25}), "values go to and fro"); // though the last three do
}
} // namespace
} // namespace ricochet::tests
