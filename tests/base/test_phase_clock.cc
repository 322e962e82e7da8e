// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/phase_clock.h"

#include <gtest/gtest.h>

#include <ctime>
#include <numeric>

namespace ricochet::tests
{
namespace
{
double processor_time()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void work_for(const double seconds)
{
  const double end = processor_time() + seconds;
  while (processor_time() < end)
    ;
}

TEST(PhaseClock, WorkWithinWorkCountsForItselfAlone)
{
  const auto before = PhaseClock::seconds();
  {
    const PhaseClock::Work outer(Phase::zones);
    work_for(0.02);
    {
      const PhaseClock::Work inner(Phase::calibration);
      work_for(0.03);
    }
    work_for(0.01);
  }
  work_for(0.005);
  const auto after  = PhaseClock::seconds();
  const auto passed = [&](const Phase phase)
  { return after[static_cast<int>(phase)] - before[static_cast<int>(phase)]; };
  // The clocks are read at slightly other times: a millisecond is plenty.
  EXPECT_NEAR(passed(Phase::zones), 0.03, 1e-3);
  EXPECT_NEAR(passed(Phase::calibration), 0.03, 1e-3);
  EXPECT_NEAR(passed(Phase::rest), 0.005, 1e-3);
  EXPECT_EQ(passed(Phase::debris), 0.);
}

TEST(PhaseClock, PhasesAddUpToTheTimeOfTheProcess)
{
  const auto seconds = PhaseClock::seconds();
  EXPECT_NEAR(std::accumulate(seconds.begin(), seconds.end(), 0.), processor_time(), 1e-3);
}

TEST(PhaseClock, EveryPhaseHasAName)
{
  for (const char *name : phase_names)
    EXPECT_NE(name, nullptr);
  EXPECT_STREQ(phase_names[static_cast<int>(Phase::checkpoints)], "checkpoints");
}
} // namespace
} // namespace ricochet::tests
