// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/text_tools.h"
#include "scene_sections.h"
#include "section_checks.h"
#include "study_axis.h"
#include "study_section.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
namespace
{
namespace fs = std::filesystem;

/// A case before its file is read.
struct Plan
{
  std::string name, scene_file, scene;
  std::vector<ParameterEntry> overrides = {};
  std::vector<std::size_t> values       = {}; // of every axis in turn
};

/// "grid_spacing", with its section in front if another axis has an entry of the same name.
std::string short_name(const StudyAxis &axis, const std::vector<StudyAxis> &axes)
{
  const ParameterEntry &entry = axis.entries.front();
  const auto n_same =
      std::count_if(axes.begin(), axes.end(),
                    [&](const auto &other) { return other.entries.front().name == entry.name; });
  return file_name_of(lower_case(n_same > 1 ? entry.section + " " + entry.name : entry.name));
}

std::string value_name(const std::size_t axis, const std::size_t value,
                       const std::vector<StudyAxis> &axes)
{
  return short_name(axes[axis], axes) + "_" + file_name_of(axes[axis].values[value]);
}

/// The plan with one more axis, at its value number v.
Plan with_value(Plan plan, const std::vector<StudyAxis> &axes, const std::size_t a,
                const std::size_t v)
{
  plan.name += "__" + value_name(a, v, axes);
  plan.values.push_back(v);
  const auto parts = split(axes[a].values[v], ';');
  for (std::size_t e = 0; e < axes[a].entries.size(); ++e)
  {
    plan.overrides.push_back(axes[a].entries[e]);
    plan.overrides.back().value = parts[parts.size() == 1 ? 0 : e];
  }
  return plan;
}

Plan plan_of(const std::string &scene)
{
  return {scene_name(scene), scene, scene_name(scene)};
}

std::vector<Plan> cases_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<Plan> cases{plan_of(scene)};
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    std::vector<Plan> finer;
    for (const auto &coarse : cases)
      for (std::size_t v = 0; v < axes[a].values.size(); ++v)
        finer.push_back(with_value(coarse, axes, a, v));
    cases = std::move(finer);
  }
  return cases;
}

/// The scene itself, then with one value of one axis at a time.
std::vector<Plan> single_changes_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<Plan> cases = cases_of(scene, {});
  for (const auto &axis : axes)
    for (auto &next : cases_of(scene, {axis}))
      cases.push_back(std::move(next));
  return cases;
}

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

/// One value of every axis side by side.
std::vector<Plan> zipped_cases_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<Plan> cases;
  for (std::size_t v = 0; v < (axes.empty() ? 1 : axes[0].values.size()); ++v)
  {
    cases.push_back(plan_of(scene));
    for (std::size_t a = 0; a < axes.size(); ++a)
      cases.back() = with_value(cases.back(), axes, a, v);
  }
  return cases;
}

std::vector<Plan> plans_of(const std::string &scene, const StudyParameters &study)
{
  switch (study.combination)
  {
    case Combination::all:
      return cases_of(scene, study.axes);
    case Combination::one_at_a_time:
      return single_changes_of(scene, study.axes);
    case Combination::zipped:
      return zipped_cases_of(scene, study.axes);
  }
  return {};
}

/// What tells a case from the others, to be read.
std::string label_of(const Plan &plan, const std::size_t n_scenes)
{
  std::vector<std::string> parts;
  if (n_scenes > 1 || plan.overrides.empty())
  {
    std::string scene = plan.scene;
    std::replace(scene.begin(), scene.end(), '_', ' ');
    parts.push_back(scene);
  }
  std::string told;
  for (const auto &entry : plan.overrides)
  {
    const auto quantity  = parse_free_quantity(entry.value);
    const bool has_unit  = quantity && !quantity->unit.empty();
    const bool is_common = entry.value == told; // of entries that are changed together
    told                 = entry.value;
    if (!is_common)
      parts.push_back(has_unit ? entry.value : lower_case(entry.name) + " " + entry.value);
  }
  return joined(parts);
}

/// Reads the file of a case, and all that it says.
StudyCase read_case(const Plan &plan, const bool is_compared)
{
  try
  {
    StudyCase one{
        plan.name, plan.scene, plan.values, ParameterFile(plan.scene_file, plan.overrides),
        false,     "",         {}};
    one.is_experiment = is_stability_file(one.file);
    if (one.is_experiment && is_compared)
      throw InputError(plan.scene_file + ": A stability experiment has no path and cannot be "
                                         "compared with a reference.\n  Remove 'Study/Reference'.");
    if (one.is_experiment)
      read_stability(one.file);
    else
      read_scene(one.file);
    return one;
  }
  catch (const InputError &error) // the scene does not know that it is part of a study
  {
    throw InputError(std::string(error.what()) + "\n  This concerns the study's case " +
                     in_quotes(plan.name) + ".");
  }
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
  check_names(*settings.scenes_row, plans);
  if (!study.reference.empty())
    std::stable_sort(plans.begin(), plans.end(),
                     [](const auto &a, const auto &b) { return a.values < b.values; });

  const auto columns = columns_of(study.axes);
  for (const auto &column : columns)
    study.axis_columns.push_back(column.column);
  for (auto &plan : plans)
  {
    const std::string label = label_of(plan, settings.scenes.size());
    plan.overrides.insert(plan.overrides.end(), settings.overrides.begin(),
                          settings.overrides.end());
    plan.overrides.push_back({"Output", "Directory", study.output_directory + "/" + plan.name,
                              settings.directory_row->origin()});
    StudyCase one = read_case(plan, !study.reference.empty());
    one.label     = label;
    for (const auto &[column, entry] : columns)
      one.axis_values.push_back(value_in(column, used_value(one.file, entry.section, entry.name)));
    study.cases.push_back(std::move(one));
  }
  return study;
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
