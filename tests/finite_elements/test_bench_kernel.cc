// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/drivers/bench.h"

#include <gtest/gtest.h>
#include <mpi.h>
#include <nlohmann/json.hpp>

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
