// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ensemble.h"

#include "ricochet/base/units.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// The position of a run at a stated time [us], or null.
const Json *position_at(const Json &run, const double stated_time)
{
  if (const auto positions = run.find("positions"); positions != run.end())
    for (const auto &position : *positions)
      if (position["stated_us"] == stated_time)
        return &position;
  return nullptr;
}

/// Path [mm] and place of the centroid at the stated time itself. Positions are noted in the first
/// step after it; that this step lies elsewhere in every run would look like an error, so what has
/// been flown since is taken back. Impacts fly along +x.
double path_at(const Json &position)
{
  const double late = position["time_us"].get<double>() - position["stated_us"].get<double>();
  return position["path_mm"].get<double>() -
         1e-3 * late * position["speed_m_s"].get<double>(); // us m/s = 1e-3 mm
}

Eigen::Vector3d place(const Json &position)
{
  const double flown = position["path_mm"].get<double>() - path_at(position);
  const double angle = position["angle_deg"].get<double>() * units::deg;
  return {position["x_mm"].get<double>() - flown * std::cos(angle), position["y_mm"].get<double>(),
          position["z_mm"].get<double>() - flown * std::sin(angle)};
}

/// Mean position and path [mm] of an ensemble at a time that all its runs have reached.
std::pair<Eigen::Vector3d, double> mean_at(const Ensemble &runs, const double stated_time)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double path          = 0.;
  for (const auto &run : runs)
  {
    const Json &position = *position_at(run, stated_time);
    mean += place(position) / double(runs.size());
    path += path_at(position) / double(runs.size());
  }
  return {mean, path};
}

/// Smallest and largest distance of single runs from a place [mm].
std::pair<double, double> distances_from(const Eigen::Vector3d &mean, const Ensemble &runs,
                                         const double stated_time)
{
  double low = std::numeric_limits<double>::infinity(), high = 0.;
  for (const auto &run : runs)
  {
    const double distance = (place(*position_at(run, stated_time)) - mean).norm();
    low                   = std::min(low, distance);
    high                  = std::max(high, distance);
  }
  return {low, high};
}

struct Values
{
  double median, low, high;
};

/// Nothing if there are no values.
std::optional<Values> values_of(std::vector<double> values)
{
  if (values.empty())
    return {};
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return Values{0.5 * (values[(n - 1) / 2] + values[n / 2]), values.front(), values.back()};
}

std::optional<Values> core_seconds(const Ensemble &runs)
{
  std::vector<double> seconds;
  for (const auto &run : runs)
    seconds.push_back(run["core_seconds"]);
  return values_of(seconds);
}

/// Of the runs whose projectile has left; the speed of the others is that at the final time.
std::optional<Values> exit_speeds(const Ensemble &runs)
{
  std::vector<double> speeds;
  for (const auto &run : runs)
    if (run["outcome"] != "undecided" && run["outcome"] != "stuck")
      speeds.push_back(run["exit_speed_m_s"]);
  return values_of(speeds);
}

/// Outcomes and how many runs have each, the most frequent first.
std::vector<std::pair<std::string, std::size_t>> outcomes(const Ensemble &runs)
{
  std::map<std::string, std::size_t> counts;
  for (const auto &run : runs)
    ++counts[run["outcome"]];
  std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto &a, const auto &b) { return a.second > b.second; });
  return sorted;
}

/// "3 ricochet, 1 perforate"
std::string outcome_text(const Ensemble &runs)
{
  std::string text;
  for (const auto &[outcome, n] : outcomes(runs))
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + outcome;
  return text;
}

/// How most runs end, or "" if there is no majority or it is undecided.
std::string usual_outcome(const Ensemble &runs)
{
  const auto all = outcomes(runs);
  return all.empty() || 2 * all[0].second <= runs.size() || all[0].first == "undecided"
             ? ""
             : all[0].first;
}
} // namespace

const std::vector<std::string> comparison_columns{"runs",
                                                  "outcomes",
                                                  "same_outcome",
                                                  "compared_at_us",
                                                  "reference_path_mm",
                                                  "path_error_percent",
                                                  "path_error_low_percent",
                                                  "path_error_high_percent",
                                                  "reference_scatter_percent",
                                                  "exit_speed_m_s",
                                                  "exit_speed_low_m_s",
                                                  "exit_speed_high_m_s",
                                                  "exit_speed_error_percent",
                                                  "core_seconds",
                                                  "core_seconds_low",
                                                  "core_seconds_high",
                                                  "cost_ratio"};

Json percent(const double share)
{
  return std::isfinite(share) ? Json(100. * share) : Json();
}

std::vector<PathError> path_errors(const Ensemble &runs, const Ensemble &reference)
{
  std::vector<PathError> errors;
  if (runs.empty() || reference.empty() || !reference[0].contains("positions"))
    return errors;
  for (const auto &position : reference[0]["positions"])
  {
    const double time    = position["stated_us"];
    const auto all_reach = [&](const Ensemble &ensemble)
    {
      return std::all_of(ensemble.begin(), ensemble.end(),
                         [&](const Json &run) { return position_at(run, time) != nullptr; });
    };
    if (!all_reach(runs) || !all_reach(reference))
      continue;
    const auto [mean, path] = mean_at(reference, time);
    if (!(path > 0.))
      continue;
    const auto [low, high] = distances_from(mean, runs, time);
    const double scatter   = reference.size() > 1
                                 ? distances_from(mean, reference, time).second / path
                                 : std::numeric_limits<double>::quiet_NaN();
    errors.push_back({time, path, (mean_at(runs, time).first - mean).norm() / path, low / path,
                      high / path, scatter});
  }
  return errors;
}

Json compare(const Ensemble &runs, const Ensemble &reference)
{
  Json row;
  for (const auto &column : comparison_columns)
    row[column] = nullptr;
  row["runs"]     = runs.size();
  row["outcomes"] = runs.empty() ? Json() : Json(outcome_text(runs));
  if (const auto usual = usual_outcome(reference); !usual.empty() && !runs.empty())
    row["same_outcome"] =
        double(std::count_if(runs.begin(), runs.end(),
                             [&](const Json &run) { return run["outcome"] == usual; })) /
        double(runs.size());
  if (const auto errors = path_errors(runs, reference); !errors.empty())
  {
    const PathError &last            = errors.back();
    row["compared_at_us"]            = last.stated_time;
    row["reference_path_mm"]         = last.path;
    row["path_error_percent"]        = percent(last.error);
    row["path_error_low_percent"]    = percent(last.low);
    row["path_error_high_percent"]   = percent(last.high);
    row["reference_scatter_percent"] = percent(last.scatter);
  }
  if (const auto speed = exit_speeds(runs))
  {
    row["exit_speed_m_s"]      = speed->median;
    row["exit_speed_low_m_s"]  = speed->low;
    row["exit_speed_high_m_s"] = speed->high;
    if (const auto wanted = exit_speeds(reference); wanted && wanted->median > 0.)
      row["exit_speed_error_percent"] = percent(speed->median / wanted->median - 1.);
  }
  if (const auto cost = core_seconds(runs))
  {
    row["core_seconds"]      = cost->median;
    row["core_seconds_low"]  = cost->low;
    row["core_seconds_high"] = cost->high;
    if (const auto whole = core_seconds(reference); whole && whole->median > 0.)
      row["cost_ratio"] = cost->median / whole->median;
  }
  return row;
}
} // namespace ricochet
