// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/schedule.h"

#include <gtest/gtest.h>

#include <vector>

namespace ricochet
{
namespace
{
/// The steps, of one second, at which it is due.
std::vector<int> due_steps(const double interval, const int n_steps)
{
  Schedule schedule(interval);
  std::vector<int> steps;
  for (int step = 0; step < n_steps; ++step)
    if (schedule.is_due(step))
    {
      steps.push_back(step);
      schedule.done(step);
    }
  return steps;
}

TEST(Schedule, IsDueInTheFirstStepThatIsNotBefore)
{
  EXPECT_EQ(due_steps(2.5, 11), (std::vector<int>{0, 3, 5, 8, 10}));
}

TEST(Schedule, ShorterThanAStepIsDueInEveryStep)
{
  for (const double interval :
       {1., 0.9, 0.3, 1e-9, 1e-30, std::numeric_limits<double>::denorm_min()})
    EXPECT_EQ(due_steps(interval, 4), (std::vector<int>{0, 1, 2, 3})) << interval;
}

TEST(Schedule, LeftAloneForLongFallsBackOnItsGrid)
{
  Schedule schedule(2.);
  schedule.done(7.5);
  EXPECT_FALSE(schedule.is_due(7.9));
  EXPECT_TRUE(schedule.is_due(8.));
}

TEST(Schedule, WithoutAnIntervalIsNeverDue)
{
  EXPECT_TRUE(due_steps(0., 4).empty());
}
} // namespace
} // namespace ricochet
