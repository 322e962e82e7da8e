// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/progress.h"

#include "support/scratch_directory.h"

#include <algorithm>
#include <thread>

namespace ricochet
{
namespace
{
using namespace tests;

ProgressState state_at(const double time)
{
  return {time, 1000, 512.34, -12.5, 123456., 0.0012, 812e6};
}

TEST(Progress, LogHasALineEveryTenPercent)
{
  std::ostringstream out;
  Progress progress(out, 100e-6, Progress::Style::log);
  for (int i = 0; i <= 1000; ++i)
    progress.update(state_at(i * 1e-7));
  progress.finish();
  const std::vector<std::string> lines = split(out.str(), '\n');
  ASSERT_EQ(lines.size(), 11u);
  for (int i = 0; i <= 10; ++i)
    EXPECT_EQ(std::stoi(lines[i]), 10 * i);
  for (const char *part : {"50 %", "50.0 us", "512.3 m/s", "-12.5 deg", "123 k", "+0.12 %", "left"})
    EXPECT_TRUE(contains(lines[5], part)) << part << " in " << lines[5];
  EXPECT_EQ(out.str().find_first_of("\r\033"), std::string::npos);
}

TEST(Progress, LineFitsInto80Columns)
{
  std::ostringstream out;
  Progress progress(out, 2e-3, Progress::Style::log);
  for (const double time : {0., 1e-6, 1.5e-3, 2e-3})
    progress.update({time, 1000000, 1234.56, -123.4, 9.99949e12, -0.1234, 812e9});
  progress.finish();
  for (const auto &line : split(out.str(), '\n'))
    EXPECT_LT(line.size(), 80u) << line;
}

TEST(Progress, EarlyEndIsShownOnce)
{
  std::ostringstream out;
  Progress progress(out, 100e-6, Progress::Style::log);
  progress.update(state_at(0.));
  progress.update(state_at(7e-6));
  progress.finish();
  progress.finish();
  const std::vector<std::string> lines = split(out.str(), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(contains(lines[1], " 7.0 us")) << lines[1];
}

TEST(Progress, TerminalLineIsRewrittenAtMostFiveTimesASecond)
{
  std::ostringstream out;
  Progress progress(out, 100e-6, Progress::Style::terminal);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 30; ++i)
  {
    progress.update(state_at(i * 1e-6));
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.finish();
  const std::string text = out.str();
  const auto n           = std::count(text.begin(), text.end(), '\r');
  EXPECT_GE(n, 3); // the first, at least one more, and the last
  EXPECT_LE(n, 2 + seconds / 0.2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, QuietPrintsNothing)
{
  ::testing::internal::CaptureStdout();
  Progress progress(MPI_COMM_WORLD, 100e-6, /*quiet=*/true);
  progress.update(state_at(50e-6));
  progress.finish();
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(Progress, OnlyRankZeroPrints)
{
  ::testing::internal::CaptureStdout(); // now a file, hence the style of a log
  Progress progress(MPI_COMM_WORLD, 100e-6, /*quiet=*/false);
  progress.update(state_at(100e-6));
  progress.finish();
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(contains(text, "100 %"), rank() == 0) << text;
  EXPECT_EQ(text.empty(), rank() != 0) << text;
}
} // namespace
} // namespace ricochet
