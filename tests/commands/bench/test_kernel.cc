// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/bench/history.h"
#include "commands/bench/kernel.h"
#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>
#include <mpi.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>
#include <string>

namespace ricochet::tests
{
namespace
{
TEST(BenchKernel, ComparesRelaxingBondsWithElasticOnes)
{
  KernelBenchOptions options;
  options.points_per_edge = 12;
  options.repeats         = 1;
  options.json            = true;
  for (const int branches : {0, 1, 2})
    for (const char *history : {"single", "double"})
    {
      options.branches = branches;
      options.history  = history;
      testing::internal::CaptureStdout();
      bench_kernel(MPI_COMM_SELF, options);
      const auto result = nlohmann::json::parse(testing::internal::GetCapturedStdout());
      EXPECT_EQ(result["points"], 12 * 12 * 12);
      EXPECT_GT(result["directed_bonds_per_second_per_core"], 0.);
      EXPECT_EQ(result.contains("share_of_elastic_rate"), branches > 0);
      if (branches == 0)
        continue;
      EXPECT_EQ(result["relaxing_branches"], branches);
      // 46 forward bonds and one theta per branch; tension, dissipation and lost theta per point.
      const double bytes = history == std::string("single") ? 4. : 8.;
      EXPECT_EQ(result["history_bytes_per_point"], branches * (46 * bytes + 8.) + 24.);
    }
}

TEST(BenchHistory, SinglePrecisionErrsWhereAHalfDigitStalls)
{
  testing::internal::CaptureStdout();
  bench_history(MPI_COMM_SELF, {3});
  std::istringstream text(testing::internal::GetCapturedStdout());
  int n_rows = 0;
  for (std::string line; std::getline(text, line); ++n_rows)
  {
    const auto row    = nlohmann::json::parse(line);
    const double step = row["dt_per_relaxation_time"];
    EXPECT_NEAR(step, std::pow(0.1, n_rows), 1e-12);
    // Rounding of every step adds up like a random walk, below the half digit at which it stalls.
    EXPECT_GT(row["error_held"], 0.);
    EXPECT_LT(row["error_held"], 6e-8 / step);
    EXPECT_LT(row["error_pulled"], row["error_held"]);
  }
  EXPECT_EQ(n_rows, 4);
  EXPECT_THROW(bench_history(MPI_COMM_SELF, {0}), InputError);
}

TEST(BenchKernel, RefusesWhatItDoesNotKnow)
{
  KernelBenchOptions options;
  options.history = "half";
  EXPECT_THROW(bench_kernel(MPI_COMM_SELF, options), InputError);
  options          = {};
  options.branches = 9;
  EXPECT_THROW(bench_kernel(MPI_COMM_SELF, options), InputError);
}
} // namespace
} // namespace ricochet::tests
