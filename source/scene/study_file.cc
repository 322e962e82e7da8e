// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"
#include "scene_sections.h"
#include "section_checks.h"
#include "study_axis.h"
#include "study_limit.h"
#include "study_plan.h"
#include "study_section.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
namespace fs = std::filesystem;

namespace
{
void check_names(const Entry &scenes, const std::vector<Plan> &cases)
{
  for (auto one = cases.begin(); one != cases.end(); ++one)
    for (auto other = cases.begin(); other != one; ++other)
      if (one->name == other->name)
        scenes.fail("Two cases would be called " + in_quotes(one->name) + ".",
                    one->scene_file == other->scene_file
                        ? "List every scene once, and values that differ in letters or digits."
                        : "Rename " + in_quotes(one->scene_file) + " or " +
                              in_quotes(other->scene_file) + ".");
}

} // namespace

void check_columns(const StudyParameters &study, const std::vector<std::string> &known)
{
  for (const auto &column : study.columns)
    if (std::find(known.begin(), known.end(), column) == known.end())
      throw InputError(study.columns_origin + ": " + study_name + "/Columns = " +
                       in_quotes(column) + ": There is no such column" + guess(column, known) +
                       "\n  Columns are fields of summary.json, which 'ricochet columns' prints.");
}

bool is_study_file(const ParameterFile &file)
{
  const auto &sections = file.sections();
  return std::any_of(sections.begin(), sections.end(),
                     [](const auto &present) { return present.name == study_name; });
}

StudyParameters read_study(const std::string &path)
{
  const ParameterFile file(path);
  if (!is_study_file(file))
    throw InputError(path + ": This file has no section 'Study'.\n  A single scene is run with "
                            "'ricochet run'.");
  StudyParameters study{};
  study.path = path;
  StudySettings settings;
  std::vector<Section> sections;
  sections.push_back(study_section(stem_of(file), study, settings));
  read_and_check_sections(file, sections);

  std::vector<Plan> plans;
  for (const auto &scene : settings.scenes)
  {
    study.scenes.push_back((fs::path(path).parent_path() / scene).lexically_normal().string());
    if (!fs::exists(study.scenes.back()))
      settings.scenes_row->fail("There is no file " + in_quotes(study.scenes.back()) + ".",
                                "The scenes are relative to the study's own file.");
    for (auto &next : plans_of(study.scenes.back(), study))
      plans.push_back(std::move(next));
  }
  study.shared           = settings.overrides;
  study.directory_origin = settings.directory_row->origin();
  check_names(*settings.scenes_row, plans);
  if (!study.reference.empty())
    std::stable_sort(plans.begin(), plans.end(),
                     [](const auto &a, const auto &b) { return a.values < b.values; });

  for (const auto &column : columns_of(study.axes))
    study.axis_columns.push_back(column.column);
  if (study.limit)
    study.limit->column = study.axis_columns.size() - 1;
  for (auto &plan : plans)
    study.cases.push_back(make_case(study, std::move(plan)));
  return study;
}

void add_limit_case(StudyParameters &study, const std::size_t like, const double value)
{
  const StudyCase &sibling = study.cases[like];
  StudyAxis &axis          = study.axes[study.limit->axis];
  const std::string text   = in_unit(value, study.axis_columns[study.limit->column].unit);
  auto found               = std::find(axis.values.begin(), axis.values.end(), text);
  if (found == axis.values.end())
    found = axis.values.insert(found, text);
  Plan plan = plan_of(*std::find_if(study.scenes.begin(), study.scenes.end(),
                                    [&](const std::string &scene)
                                    { return scene_name(scene) == sibling.scene; }));
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    plan = with_value(plan, study.axes, a,
                      a == study.limit->axis ? found - axis.values.begin() : sibling.values[a]);
  study.cases.push_back(make_case(study, std::move(plan)));
}

std::string group_name(const StudyParameters &study, const StudyCase &one)
{
  std::string name;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (!study.axes[a].is_ensemble)
      name += (name.empty() ? "" : "__") + value_name(a, one.values[a], study.axes);
  return name;
}

std::string group_title(const StudyParameters &study, const StudyCase &one)
{
  std::vector<std::string> titles;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (const StudyAxis &axis = study.axes[a]; !axis.is_ensemble)
    {
      const std::string title = joined(split(axis.values[one.values[a]], ';'));
      const bool is_number    = title.find_first_not_of("0123456789.+-eE, ") == std::string::npos;
      titles.push_back(is_number ? lower_case(axis.entries[0].name) + " " + title : title);
    }
  return joined(titles);
}
} // namespace ricochet
