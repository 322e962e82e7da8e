// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/stability_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ricochet
{
namespace
{
TEST(StabilityRun, DescriptionHasTheNumbersOfItsSummary)
{
  nlohmann::ordered_json summary{
      {"verdict", "inaccurate"}, {"reason", "strain error"},       {"growth_per_step", 1.23456e-5},
      {"growth_per_us", 0.01},   {"energy_drift", 2.5e-3},         {"strain_error", 0.0123},
      {"ghost_force", 0.456},    {"step_over_measured_limit", 0.8}};
  EXPECT_EQ(describe_stability(summary),
            "inaccurate: strain error. Kinetic energy grows by 1.23e-05 per step (0.01 per us); "
            "discrete energy drifts by 0.0025; strain error 1.2 %, ghost force 0.46 M eps h^2; the "
            "step is 0.800 of the largest stable one.");
  summary["reason"] = "";
  EXPECT_EQ(describe_stability(summary).rfind("inaccurate. Kinetic", 0), 0u);
}

TEST(StabilityRun, ColumnsOfATableAreFieldsOfTheSummary)
{
  const auto fields = stability_fields();
  for (const auto &column : stability_columns)
    EXPECT_NE(std::find(fields.begin(), fields.end(), column), fields.end()) << column;
}
} // namespace
} // namespace ricochet
