// SPDX-License-Identifier: LGPL-2.1-or-later
#include "comparison.h"

#include "ricochet/base/units.h"
#include "ricochet/output/table.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

const std::vector<std::string> name_columns{"case", "scene", "group", "title", "reference"};

/// In the order in which compare() fills them in.
const std::vector<std::string> value_columns{"runs",
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

std::string formatted(const char *format, const Json &value)
{
  if (!value.is_number())
    return "-";
  char text[64];
  std::snprintf(text, sizeof text, format, value.get<double>());
  return text;
}

/// "305 (106 to 337)"
std::string with_range(const char *format, const Json &row, const std::string &name,
                       const std::string &unit)
{
  const Json &middle = row[name + unit], &low = row[name + "_low" + unit],
             &high = row[name + "_high" + unit];
  if (!middle.is_number() || low == high)
    return formatted(format, middle);
  return formatted(format, middle) + " (" + formatted(format, low) + " to " +
         formatted(format, high) + ")";
}

/// One line for the eye.
std::vector<Json> line(const std::string &name, const Json &row, const bool is_reference,
                       const std::size_t n_planned)
{
  std::string runs = formatted("%.0f", row["runs"]);
  if (row["runs"] != n_planned)
    runs += " of " + std::to_string(n_planned);
  const auto unless_reference = [&](const std::string &text) { return is_reference ? "-" : text; };
  return {name,
          runs,
          formatted("%g us", row["compared_at_us"]),
          unless_reference(with_range("%.2g", row, "path_error", "_percent")),
          formatted("%.2g", row["reference_scatter_percent"]),
          with_range("%.0f", row, "exit_speed", "_m_s"),
          unless_reference(formatted("%+.1f", row["exit_speed_error_percent"])),
          formatted("%.3g", row["core_seconds"]),
          formatted("%.2f", row["cost_ratio"]),
          row["outcomes"]};
}

struct Group
{
  std::string scene, name, title; // its scene; the values of the axes that are not the ensemble's
  Ensemble runs;
  std::size_t n_planned = 0;
};

std::vector<Group> groups_of(const StudyParameters &study, const std::vector<Json> &summaries)
{
  std::vector<Group> groups;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
  {
    const std::string scene = study.cases[i].scene, name = group_name(study, study.cases[i]);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group &other)
                              { return other.scene == scene && other.name == name; });
    if (group == groups.end())
      group = groups.insert(groups.end(), {scene, name, group_title(study, study.cases[i]), {}, 0});
    ++group->n_planned;
    const Json &summary = summaries[i];
    if (summary.is_object() && !summary.value("failed", true) &&
        !summary.value("interrupted", true))
      group->runs.push_back(summary);
  }
  return groups;
}
} // namespace

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
  for (const auto &column : value_columns)
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

Comparison compare_scenes(const StudyParameters &study, const std::vector<Json> &summaries)
{
  const auto groups = groups_of(study, summaries);
  auto columns      = name_columns;
  columns.insert(columns.end(), value_columns.begin(), value_columns.end());
  Table values(columns);
  Table paths({"case", "stated_us", "reference_path_mm", "path_error_percent",
               "path_error_low_percent", "path_error_high_percent", "reference_scatter_percent"});
  Table text({"case", "runs", "path at", "path error %", "scatter %", "exit speed m/s",
              "speed error %", "core-seconds", "of reference", "outcomes"});
  for (const auto &group : groups)
  {
    const auto named = [&](const std::string &scene)
    { return group.name.empty() ? scene : scene + "__" + group.name; };
    const std::string name = named(group.scene);
    const auto &reference =
        std::find_if(groups.begin(), groups.end(),
                     [&](const Group &other)
                     { return other.scene == study.reference && other.name == group.name; })
            ->runs;
    const Json row = compare(group.runs, reference);
    std::vector<Json> cells{name, group.scene, group.title,
                            group.runs.empty() ? Json() : group.runs[0].value("title", Json()),
                            named(study.reference)};
    for (const auto &column : value_columns)
      cells.push_back(row[column]);
    values.add(cells);
    for (const auto &e : path_errors(group.runs, reference))
      paths.add({name, e.stated_time, e.path, percent(e.error), percent(e.low), percent(e.high),
                 percent(e.scatter)});
    text.add(line(name, row, group.scene == study.reference, group.n_planned));
  }
  return {values.csv(), paths.csv(), text.text()};
}
} // namespace ricochet
