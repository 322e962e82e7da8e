// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_plan.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/text_tools.h"
#include "study_axis.h"
#include "study_section.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// "grid_spacing", with its section in front if another axis has an entry of the same name.
std::string short_name(const StudyAxis &axis, const std::vector<StudyAxis> &axes)
{
  const ParameterEntry &entry = axis.entries.front();
  const auto n_same =
      std::count_if(axes.begin(), axes.end(),
                    [&](const auto &other) { return other.entries.front().name == entry.name; });
  return file_name_of(lower_case(n_same > 1 ? entry.section + " " + entry.name : entry.name));
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

std::string value_name(const std::size_t axis, const std::size_t value,
                       const std::vector<StudyAxis> &axes)
{
  return short_name(axes[axis], axes) + "_" + file_name_of(axes[axis].values[value]);
}

Plan plan_of(const std::string &scene)
{
  return {scene_name(scene), scene, scene_name(scene)};
}

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

StudyCase make_case(const StudyParameters &study, Plan plan)
{
  const std::string label = label_of(plan, study.scenes.size());
  plan.overrides.insert(plan.overrides.end(), study.shared.begin(), study.shared.end());
  plan.overrides.push_back(
      {"Output", "Directory", study.output_directory + "/" + plan.name, study.directory_origin});
  StudyCase one = read_case(plan, !study.reference.empty());
  one.label     = label;
  for (const auto &[column, entry] : columns_of(study.axes))
    one.axis_values.push_back(value_in(column, used_value(one.file, entry.section, entry.name)));
  return one;
}
} // namespace ricochet
