// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/bench/harness.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace ricochet
{
namespace
{
TEST(BenchHarness, TimesInTurnAndSorts)
{
  std::string order;
  const auto rates = time_steps(
      MPI_COMM_SELF, /*n_repeats=*/3, /*n_steps=*/2, /*work_per_step=*/10.,
      [&]
      {
        order += 's';
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      },
      [&] { order += 'c'; });
  EXPECT_EQ(order, "ccssccssccss");
  ASSERT_EQ(rates.values.size(), 3u);
  ASSERT_EQ(rates.shares.size(), 3u);
  EXPECT_LE(rates.values[0], rates.values[1]);
  EXPECT_LE(rates.values[1], rates.values[2]);
  EXPECT_LE(rates.values[2], 10. / 2e-3); // a step sleeps at least that long
  EXPECT_LT(rates.shares[2], 1.);
}

TEST(BenchHarness, WithoutComparisonThereAreNoShares)
{
  int n_steps      = 0;
  const auto rates = time_steps(MPI_COMM_SELF, 2, 5, 1., [&] { ++n_steps; });
  EXPECT_EQ(n_steps, 10);
  EXPECT_TRUE(rates.shares.empty());
}

TEST(BenchHarness, ReportsMedianWorstAndBest)
{
  const Rates rates{4, {1e6, 2e6, 4e6}, {0.5, 0.625, 0.75}};
  const RateName name{"things", "things", 1};
  EXPECT_EQ(describe(name, 2, rates),
            "2 ranks: 2.0 M things/s per core (worst 1.0, best 4.0 of 3)");
  EXPECT_EQ(describe_shares(rates), "0.62 of the elastic rate (worst 0.50, best 0.75)");
  nlohmann::ordered_json facts;
  add_rates(facts, name, 1, rates);
  EXPECT_EQ(facts["steps"], 12);
  EXPECT_EQ(facts["things_per_second_per_core"], 2e6);
  EXPECT_EQ(facts["things_per_second_per_core_worst"], 1e6);
  EXPECT_EQ(facts["things_per_second_per_core_best"], 4e6);
}
} // namespace
} // namespace ricochet
