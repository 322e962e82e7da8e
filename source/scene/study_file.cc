// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "parameters.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "text_tools.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
namespace
{
namespace fs = std::filesystem;

constexpr const char *section = "Study";

/// The parts of a list; an empty list has none. Empty parts are an error.
std::vector<std::string> read_list(const Parameters &parameters, const std::string &name)
{
  const std::string text = parameters.text(section, name);
  if (text.empty())
    return {};
  const auto parts = split(text, ',');
  if (std::find(parts.begin(), parts.end(), "") != parts.end())
    parameters.fail(section, name, "The list has an empty place.", "Remove the comma too many.");
  return parts;
}

StudyAxis read_axis(const Parameters &parameters, const std::string &name)
{
  const std::string text   = parameters.text(section, name);
  const auto colon         = text.find(':');
  const std::string origin = parameters.origin(section, name) + " (" + name + ")";
  const std::string remedy = "Write 'Section/Entry: value | value', for example 'Plate 1/Grid "
                             "spacing: 1.5 mm | 1.0 mm'.";
  if (colon == std::string::npos)
    parameters.fail(section, name, "No ':' separates the entry from its values.", remedy);

  StudyAxis axis;
  for (const auto &path : split(text.substr(0, colon), ','))
  {
    if (path.empty())
      parameters.fail(section, name, "The name of an entry is missing.", remedy);
    axis.entries.push_back(parse_override(path + "=", origin));
  }
  axis.values = split(text.substr(colon + 1), '|');
  for (auto value = axis.values.begin(); value != axis.values.end(); ++value)
  {
    if (value->empty())
      parameters.fail(section, name, "A value is missing.", remedy);
    if (std::find(axis.values.begin(), value, *value) != value)
      parameters.fail(section, name, "The value " + in_quotes(*value) + " stands there twice.",
                      "Remove one of them.");
    if (const auto n = split(*value, ';').size(); n != 1 && n != axis.entries.size())
      parameters.fail(section, name,
                      in_quotes(*value) + " gives " + std::to_string(n) + " values to " +
                          std::to_string(axis.entries.size()) + " entries.",
                      "Write one value for all entries, or one for each with ';' between them.");
  }
  return axis;
}

/// Letters, digits, points and signs as they are, everything else as one underscore.
std::string file_name_of(const std::string &text)
{
  std::string name;
  for (const char c : text)
  {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '-' || c == '+';
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (!name.empty() && name.back() == '_')
    name.pop_back();
  return name;
}

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

std::string scene_name(const std::string &scene)
{
  return file_name_of(fs::path(scene).stem().string());
}

std::vector<StudyCase> cases_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<StudyCase> cases{{scene_name(scene), scene, {}, scene_name(scene), {}}};
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    std::vector<StudyCase> finer;
    for (const auto &coarse : cases)
      for (std::size_t v = 0; v < axes[a].values.size(); ++v)
      {
        StudyCase next = coarse;
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
std::vector<StudyCase> single_changes_of(const std::string &scene,
                                         const std::vector<StudyAxis> &axes)
{
  std::vector<StudyCase> cases = cases_of(scene, {});
  for (const auto &axis : axes)
    for (auto &next : cases_of(scene, {axis}))
      cases.push_back(std::move(next));
  return cases;
}

void check_names(const Parameters &parameters, const std::vector<StudyCase> &cases)
{
  for (auto one = cases.begin(); one != cases.end(); ++one)
    for (auto other = cases.begin(); other != one; ++other)
      if (one->name == other->name)
        parameters.fail(section, "Scenes",
                        "Two cases would be called " + in_quotes(one->name) + ".",
                        one->scene_file == other->scene_file
                            ? "List every scene once, and values that differ in letters or digits."
                            : "Rename " + in_quotes(one->scene_file) + " or " +
                                  in_quotes(other->scene_file) + ".");
}

/// Entries that all cases share, "Section/Entry: value; Section/Entry: value".
std::vector<ParameterEntry> read_settings(const Parameters &parameters)
{
  const std::string name = "Settings", text = parameters.text(section, name);
  std::vector<ParameterEntry> settings;
  if (text.empty())
    return settings;
  for (const auto &part : split(text, ';'))
  {
    const auto colon = part.find(':');
    if (colon == std::string::npos || part.find('/') > colon)
      parameters.fail(section, name, in_quotes(part) + " is no entry with its value.",
                      "Write 'Section/Entry: value; Section/Entry: value', for example "
                      "'Output/Pictures: false'.");
    settings.push_back(parse_override(part.substr(0, colon) + "=" + part.substr(colon + 1),
                                      parameters.origin(section, name) + " (" + name + ")"));
  }
  return settings;
}

void read_ensemble(const Parameters &parameters, std::vector<StudyAxis> &axes,
                   const std::vector<std::string> &names)
{
  for (const auto &wanted : read_list(parameters, "Ensemble"))
  {
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end())
      parameters.fail(section, "Ensemble", in_quotes(wanted) + " is no axis of this study.",
                      names.empty() ? "The study has no axis: add 'Axis 1', for example over "
                                      "'Time/Safety factor'."
                                    : "Name one of " + joined(names, " or ") + ".");
    axes[found - names.begin()].is_ensemble = true;
  }
}

/// The name of the scene that the others are compared with, or "".
std::string read_reference(const Parameters &parameters, const StudyParameters &study,
                           const std::vector<std::string> &scenes)
{
  const std::string name = "Reference", text = parameters.text(section, name);
  if (text.empty())
  {
    if (parameters.is_given(section, "Ensemble"))
      parameters.fail(section, "Ensemble", "There is no reference to compare ensembles with.",
                      "Name one of the scenes: 'set Reference = " + scenes.front() + "'.");
    return "";
  }
  if (std::find(scenes.begin(), scenes.end(), text) == scenes.end())
    parameters.fail(section, name, in_quotes(text) + " is not among the scenes.",
                    "Write it as it stands in 'Scenes': " + joined(scenes, " or ") + ".");
  if (scenes.size() < 2)
    parameters.fail(section, name, "There is nothing to compare with it.",
                    "Add another scene to 'Scenes'.");
  if (study.one_at_a_time)
    parameters.fail(section, name,
                    "Cases are compared under the same values of all axes, but the axes are "
                    "varied one at a time.",
                    "Remove 'Combine', or the reference.");
  return scene_name(text);
}

void check_case(const StudyCase &one, const bool is_compared)
{
  try
  {
    const ParameterFile file(one.scene_file, one.overrides);
    if (is_stability_file(file) && is_compared)
      throw InputError(one.scene_file + ": A stability experiment has no path and cannot be "
                                        "compared with a reference.\n  Remove 'Study/Reference'.");
    if (is_stability_file(file))
      read_stability(file);
    else
      read_scene(file);
  }
  catch (const InputError &error) // the scene does not know that it is part of a study
  {
    throw InputError(std::string(error.what()) + "\n  This concerns the study's case " +
                     in_quotes(one.name) + ".");
  }
}
} // namespace

StudyParameters read_study(const std::string &path)
{
  const ParameterFile file(path);
  const auto &sections = file.sections();
  if (std::none_of(sections.begin(), sections.end(),
                   [](const auto &present) { return present.name == section; }))
    throw InputError(path + ": This file has no section 'Study'.\n  A single scene is run with "
                            "'ricochet run'.");
  const Parameters parameters(file, study_declarations(fs::path(path).stem().string()));

  StudyParameters study;
  study.title            = parameters.text(section, "Title");
  study.output_directory = parameters.text(section, "Output directory");
  study.columns          = read_list(parameters, "Columns");
  study.one_at_a_time    = parameters.text(section, "Combine") == "one at a time";
  study.pictures         = parameters.flag(section, "Pictures");
  std::vector<std::string> axis_names;
  for (int number = 1; number <= most_axes; ++number)
    if (const auto name = "Axis " + std::to_string(number); parameters.is_given(section, name))
    {
      study.axes.push_back(read_axis(parameters, name));
      axis_names.push_back(name);
    }
  const auto scenes   = read_list(parameters, "Scenes");
  const auto settings = read_settings(parameters);
  study.reference     = read_reference(parameters, study, scenes);
  read_ensemble(parameters, study.axes, axis_names);

  for (const auto &scene : scenes)
  {
    study.scenes.push_back((fs::path(path).parent_path() / scene).lexically_normal().string());
    if (!fs::exists(study.scenes.back()))
      parameters.fail(section, "Scenes", "There is no file " + in_quotes(study.scenes.back()) + ".",
                      "The scenes are relative to the study's own file.");
    for (auto &next : study.one_at_a_time ? single_changes_of(study.scenes.back(), study.axes)
                                          : cases_of(study.scenes.back(), study.axes))
      study.cases.push_back(std::move(next));
  }
  check_names(parameters, study.cases);
  if (!study.reference.empty())
    std::stable_sort(study.cases.begin(), study.cases.end(),
                     [](const auto &a, const auto &b) { return a.values < b.values; });

  for (auto &one : study.cases)
  {
    one.overrides.insert(one.overrides.end(), settings.begin(), settings.end());
    one.overrides.push_back({"Output", "Directory", study.output_directory + "/" + one.name,
                             parameters.origin(section, "Output directory")});
    check_case(one, !study.reference.empty());
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
