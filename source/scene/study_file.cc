// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "scene_sections.h"
#include "section_checks.h"
#include "study_section.h"
#include "text_tools.h"

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

std::vector<Plan> cases_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<Plan> cases{{scene_name(scene), scene, scene_name(scene)}};
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    std::vector<Plan> finer;
    for (const auto &coarse : cases)
      for (std::size_t v = 0; v < axes[a].values.size(); ++v)
      {
        Plan next = coarse;
        next.name += "__" + value_name(a, v, axes);
        next.values.push_back(v);
        const auto parts = split(axes[a].values[v], ';');
        for (std::size_t e = 0; e < axes[a].entries.size(); ++e)
        {
          next.overrides.push_back(axes[a].entries[e]);
          next.overrides.back().value = parts[parts.size() == 1 ? 0 : e];
        }
        finer.push_back(next);
      }
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

/// Reads the file of a case, and all that it says.
StudyCase read_case(const Plan &plan, const bool is_compared)
{
  try
  {
    StudyCase one{plan.name, plan.scene, plan.values,
                  ParameterFile(plan.scene_file, plan.overrides), false};
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
    for (auto &next : study.one_at_a_time ? single_changes_of(study.scenes.back(), study.axes)
                                          : cases_of(study.scenes.back(), study.axes))
      plans.push_back(std::move(next));
  }
  check_names(*settings.scenes_row, plans);
  if (!study.reference.empty())
    std::stable_sort(plans.begin(), plans.end(),
                     [](const auto &a, const auto &b) { return a.values < b.values; });

  for (auto &plan : plans)
  {
    plan.overrides.insert(plan.overrides.end(), settings.overrides.begin(),
                          settings.overrides.end());
    plan.overrides.push_back({"Output", "Directory", study.output_directory + "/" + plan.name,
                              settings.directory_row->origin()});
    study.cases.push_back(read_case(plan, !study.reference.empty()));
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
