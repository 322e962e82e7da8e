// SPDX-License-Identifier: LGPL-2.1-or-later
#include "comparison.h"

#include "cost_advice.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

const std::vector<std::string> name_columns{"case", "scene", "group", "title", "reference"};

/// Makes a text of a number.
using Format = std::string (*)(double);

std::string two_digits(const double value)
{
  return with_digits(value, 2);
}
std::string three_digits(const double value)
{
  return with_digits(value, 3);
}
std::string whole(const double value)
{
  return with_decimals(value, 0);
}
std::string two_decimals(const double value)
{
  return with_decimals(value, 2);
}
std::string signed_decimal(const double value)
{
  return (std::signbit(value) ? "" : "+") + with_decimals(value, 1);
}
std::string microseconds(const double value)
{
  return with_digits(value, 6) + " us";
}

/// "-" if there is no number.
std::string formatted(const Format format, const Json &value)
{
  return value.is_number() ? format(value.get<double>()) : "-";
}

/// "305 (106 to 337)"
std::string with_range(const Format format, const Json &row, const std::string &name,
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
  std::string runs = formatted(whole, row["runs"]);
  if (row["runs"] != n_planned)
    runs += " of " + std::to_string(n_planned);
  const auto unless_reference = [&](const std::string &text) { return is_reference ? "-" : text; };
  return {name,
          runs,
          formatted(microseconds, row["compared_at_us"]),
          unless_reference(with_range(two_digits, row, "path_error", "_percent")),
          formatted(two_digits, row["reference_scatter_percent"]),
          with_range(whole, row, "exit_speed", "_m_s"),
          unless_reference(formatted(signed_decimal, row["exit_speed_error_percent"])),
          formatted(three_digits, row["core_seconds"]),
          formatted(two_decimals, row["cost_ratio"]),
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

Comparison compare_scenes(const StudyParameters &study, const std::vector<Json> &summaries)
{
  const auto groups = groups_of(study, summaries);
  auto columns      = name_columns;
  columns.insert(columns.end(), comparison_columns.begin(), comparison_columns.end());
  Table values(columns);
  Table paths({"case", "stated_us", "reference_path_mm", "path_error_percent",
               "path_error_low_percent", "path_error_high_percent", "reference_scatter_percent"});
  Table text({"case", "runs", "path at", "path error %", "scatter %", "exit speed m/s",
              "speed error %", "core-seconds", "of reference", "outcomes"});
  std::vector<ComparedScene> compared;
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
    for (const auto &column : comparison_columns)
      cells.push_back(row[column]);
    values.add(cells);
    for (const auto &e : path_errors(group.runs, reference))
      paths.add({name, e.stated_time, e.path, percent(e.error), percent(e.low), percent(e.high),
                 percent(e.scatter)});
    compared.push_back({group.scene, group.title, group.scene == study.reference, row});
    text.add(line(name, row, group.scene == study.reference, group.n_planned));
  }
  return {values.csv(), paths.csv(), text.text(), cost_advice(compared)};
}
} // namespace ricochet
