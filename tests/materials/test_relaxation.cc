// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/materials/relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ricochet::tests
{
namespace
{
TEST(MaxwellStep, AgreesWithTheClosedFormForAnyRatioOfStepAndTime)
{
  // In long double the closed form has digits to spare down to 1e-4; below, two terms of the series
  // are exact.
  for (double x = 1e-12; x < 20.; x *= 1.7)
  {
    const auto step     = maxwell_step({0.3, 1. / x}, 1.);
    const long double X = 1.L / (1. / x);
    const long double r = std::exp(-X);
    const long double lag =
        X < 1e-4L ? X / 2 - X * X / 6 + X * X * X / 24 : 1.L + std::expm1(-X) / X;
    EXPECT_NEAR(step.decay, double(r), 1e-15);
    EXPECT_NEAR(step.lag / double(lag), 1., 1e-14) << x;
    EXPECT_NEAR(step.feed / double(-std::expm1(-X) * (1.L - lag)), 1., 1e-14) << x;
    EXPECT_EQ(step.share, 0.3);
  }
}

TEST(MaxwellStep, TwoHalfStepsMakeAWhole)
{
  // For an e that is linear over both.
  const MaxwellBranch branch{0.5, 3.};
  const auto whole = maxwell_step(branch, 2.), half = maxwell_step(branch, 1.);
  const double e[3] = {0.4, 0.7, 1.0}, back = 0.25;
  const auto advance = [](const MaxwellStep &s, const double b, const double from, const double to)
  { return s.decay * b + (1. - s.decay - s.lag) * from + s.lag * to; };
  EXPECT_NEAR(advance(half, advance(half, back, e[0], e[1]), e[1], e[2]),
              advance(whole, back, e[0], e[2]), 1e-15);
}

TEST(MaxwellStep, OneNumberRemembersTheSameAsTwo)
{
  const auto s = maxwell_step({0.5, 2.}, 0.3);
  double back = 0.1, e = 0.2, g = back - s.lag * e;
  for (int i = 0; i < 50; ++i)
  {
    const double next = std::sin(0.4 * i);
    EXPECT_NEAR(held(s, e, g), e - back, 1e-15);
    g = next_history(s, e, g);
    EXPECT_NEAR(held_before(s, e, g), e - back, 1e-14);
    back = s.decay * back + (1. - s.decay - s.lag) * e + s.lag * next;
    e    = next;
  }
}

TEST(Relaxation, ShareFallsFromOneToTheEquilibrium)
{
  const RelaxationSeries series{{0.146, 15.3}, {0.541, 95.4e-6}};
  EXPECT_EQ(relaxed_share(series, 0.), 1.);
  EXPECT_NEAR(relaxed_share(series, std::numeric_limits<double>::infinity()), 0.313, 1e-15);
  EXPECT_NEAR(relaxed_share(series, 95.4e-6), 1. - 0.541 * (1. - std::exp(-1.)), 1e-6);
}

TEST(Relaxation, SlowBranchesActAsElastic)
{
  const RelaxationSeries series{{0.146, 15.3}, {0.541, 95.4e-6}};
  const auto relaxing = relaxing_within(series, 600e-6);
  ASSERT_EQ(relaxing.size(), 1U);
  EXPECT_EQ(relaxing[0].share, 0.541);
  EXPECT_EQ(relaxing_within(series, 0.1).size(), 2U);
  // What is neglected: less than a thousandth of the branch.
  EXPECT_GT(std::exp(-600e-6 / 15.3), 1. - 1. / slowest_relaxation);
}

TEST(Relaxation, ImpossibleSeriesAreRefused)
{
  EXPECT_NO_THROW(check_series({}));
  EXPECT_NO_THROW(check_series({{0.4, 1.}, {0.59, 2.}}));
  EXPECT_THROW(check_series({{0.4, 1.}, {0.6, 2.}}), InputError);
  EXPECT_THROW(check_series({{0., 1.}}), InputError);
  EXPECT_THROW(check_series({{0.1, 0.}}), InputError);
  EXPECT_THROW(check_series(RelaxationSeries(9, {0.01, 1.})), InputError);
  EXPECT_THROW(check_step({{0.1, 1e-7}}, 2e-7), InputError);
  EXPECT_NO_THROW(check_step({{0.1, 2e-7}}, 2e-7));
}
} // namespace
} // namespace ricochet::tests
