// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid_levels.h"

#include "history_rows.h"
#include "ricochet/scene/text_tools.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

std::string group_of(const StudyParameters &study, const StudyCase &one)
{
  std::vector<std::string> parts;
  if (study.scenes.size() > 1)
    parts.push_back(one.scene);
  for (std::size_t a = 1; a < study.axes.size(); ++a)
    if (!study.axes[a].is_ensemble)
      parts.push_back(lower_case(study.axes[a].entries[0].name) + " " +
                      study.axes[a].values[one.values[a]]);
  return joined(parts);
}

bool takes_part(const Json &summary)
{
  return summary.is_object() && !summary.value("failed", true) &&
         !summary.value("interrupted", true);
}

std::vector<GridGroup> groups_of(const StudyParameters &study, const std::vector<Json> &summaries)
{
  std::vector<GridGroup> groups;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
  {
    const auto &one = study.cases[i];
    if (one.is_experiment || !takes_part(summaries[i]))
      continue;
    const auto name = group_of(study, one);
    auto group      = std::find_if(groups.begin(), groups.end(),
                                   [&](const GridGroup &other) { return other.name == name; });
    if (group == groups.end())
      group = groups.insert(groups.end(), {one.scene, name});
    auto &levels = group->levels;
    auto level   = std::find_if(levels.begin(), levels.end(),
                                [&](const GridLevel &other) { return other.value == one.values[0]; });
    if (level == levels.end())
      level = levels.insert(levels.end(), {one.values[0], *one.axis_values[0].number});
    level->cases.push_back(i);
  }
  for (auto &group : groups)
    std::sort(group.levels.begin(), group.levels.end(),
              [](const GridLevel &a, const GridLevel &b) { return a.size > b.size; });
  return groups;
}

/// Places and paths of all runs at the latest time that all have reached.
void read_paths(const StudyParameters &study, const std::filesystem::path &directory,
                GridGroup &group)
{
  std::map<std::size_t, HistoryRows> histories;
  group.time = std::numeric_limits<double>::infinity();
  for (const auto &level : group.levels)
    for (const std::size_t i : level.cases)
    {
      histories[i]      = read_history_rows(directory / study.cases[i].name / "history.csv");
      const auto &times = histories[i]["time"];
      group.time        = std::min(group.time, times.empty() ? 0. : times.back());
    }
  for (auto &level : group.levels)
    for (const std::size_t i : level.cases)
    {
      auto &rows    = histories[i];
      const auto at = [&](const char *column)
      { return interpolated(rows["time"], rows[column], group.time).value_or(std::nan("")); };
      level.place += Eigen::Vector3d(at("x"), at("y"), at("z")) / double(level.cases.size());
      level.paths.push_back(at("path"));
    }
}
} // namespace

std::vector<GridGroup> grid_groups(const StudyParameters &study, const std::vector<Json> &summaries,
                                   const std::filesystem::path &directory)
{
  auto groups = groups_of(study, summaries);
  for (auto &group : groups)
    read_paths(study, directory, group);
  return groups;
}
} // namespace ricochet
