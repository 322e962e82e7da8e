// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_comparison.h"
#include "ricochet/base/number_text.h"
#include "run.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace ricochet
{
namespace
{
/// "" without reference data.
std::string data_lines(const nlohmann::ordered_json &summary)
{
  const std::string text = describe_reference_data(summary);
  return text.empty() ? "" : "\ndata        " + text;
}
} // namespace

std::string describe_run(const nlohmann::ordered_json &summary)
{
  // What could not be computed is null.
  const auto number = [&](const char *key)
  { return summary[key].is_number() ? summary[key].get<double>() : std::nan(""); };
  const auto text     = [&](const char *key) { return summary[key].get<std::string>(); };
  const auto rounded  = [&](const char *key, const int n) { return with_decimals(number(key), n); };
  const auto measure  = [&](const char *key) { return with_precision(number(key), 3); };
  const auto power    = [&](const char *key) { return with_exponent(number(key), 0); };
  const auto outcome  = text("outcome");
  const bool has_left = outcome != "undecided" && outcome != "stuck";
  const std::string depth =
      summary["max_depth_mm"].is_null() ? "" : "deepest " + measure("max_depth_mm") + " mm, ";
  return "\noutcome     " + outcome + ": " + text("reason") +
         (has_left ? "\nexit        " : "\nlast        ") + measure("exit_speed_m_s") + " m/s at " +
         rounded("exit_angle_deg", 1) + " deg to the plate, pitch " + rounded("pitch_deg", 1) +
         " deg, after " + measure("time_us") + " us; " + depth + "path " + measure("path_mm") +
         " mm\nbalance     energy residual " + with_decimals(100. * number("energy_residual"), 2) +
         " % of the impact energy, momentum drift " + power("momentum_drift") +
         ", angular momentum drift " + power("angular_momentum_drift") + "\ncost        " +
         rounded("points", 0) + " points, " + rounded("steps", 0) + " steps, " +
         rounded("core_seconds", 1) + " core-seconds, " +
         with_decimals(1e-6 * number("bond_rate_per_core"), 0) + " M directed bonds/s per core" +
         data_lines(summary) + "\nresults     " + text("directory");
}
} // namespace ricochet
