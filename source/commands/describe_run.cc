// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_comparison.h"
#include "ricochet/base/number_text.h"
#include "run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ricochet
{
namespace
{
/// Lines on the second projectile and the others.
std::string describe_further(const nlohmann::ordered_json &summary)
{
  std::string lines;
  if (const auto all = summary.find("projectiles"); all != summary.end())
    for (std::size_t i = 1; i < all->size(); ++i)
    {
      const auto &one    = (*all)[i];
      const auto measure = [&](const char *key)
      { return one[key].is_number() ? with_precision(one[key].get<double>(), 3) : "nan"; };
      lines += "\nprojectile " + std::to_string(i + 1) + " " + one["outcome"].get<std::string>() +
               ": " + one["reason"].get<std::string>() + "; " + measure("exit_speed_m_s") +
               " m/s at " + measure("exit_angle_deg") + " deg, path " + measure("path_mm") + " mm";
    }
  return lines;
}

/// As a shell wants it.
std::string in_shell(const std::string &path)
{
  if (path.find_first_of(" '\"\\$&()*;<>?[]`|~") == std::string::npos)
    return path;
  std::string quoted = "'";
  for (const char c : path)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// "" without reference data.
std::string data_lines(const nlohmann::ordered_json &summary)
{
  const std::string text = describe_reference_data(summary);
  return text.empty() ? "" : "\ndata        " + text;
}

/// "points 52 %, debris 16 %, ...": the largest first, what is below 1 % left out.
std::string phase_shares(const nlohmann::ordered_json &summary)
{
  std::vector<std::pair<double, std::string>> shares;
  for (const auto &[name, seconds] : summary["phases"].items())
    shares.emplace_back(100. * seconds.get<double>() / summary["core_seconds"].get<double>(), name);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto &a, const auto &b) { return a.first > b.first; });
  std::string text;
  for (const auto &[share, name] : shares)
    if (share >= 1.)
      text += (text.empty() ? "" : ", ") + name + " " + with_decimals(share, 0) + " %";
  return text;
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
         " mm" + describe_further(summary) + "\nbalance     energy residual " +
         with_decimals(100. * number("energy_residual"), 2) +
         " % of the impact energy, momentum drift " + power("momentum_drift") +
         ", angular momentum drift " + power("angular_momentum_drift") + "\ncost        " +
         rounded("points", 0) + " points, " + rounded("steps", 0) + " steps, " +
         rounded("core_seconds", 1) + " core-seconds, " +
         with_decimals(1e-6 * number("bond_rate_per_core"), 0) + " M directed bonds/s per core" +
         "\ntime        " + phase_shares(summary) + data_lines(summary) + "\nresults     " +
         text("directory") +
         (summary.value("interrupted", false)
              ? "\ngoes on     ricochet run --resume " + in_shell(text("directory"))
              : "");
}
} // namespace ricochet
