// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/parameters.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/text_tools.h"

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

std::vector<StudyCase> cases_of(const std::string &scene, const std::vector<StudyAxis> &axes)
{
  std::vector<StudyCase> cases{{file_name_of(fs::path(scene).stem().string()), scene, {}}};
  for (const auto &axis : axes)
  {
    std::vector<StudyCase> finer;
    for (const auto &coarse : cases)
      for (const auto &value : axis.values)
      {
        StudyCase next = coarse;
        next.name += "__" + short_name(axis, axes) + "_" + file_name_of(value);
        for (ParameterEntry entry : axis.entries)
        {
          entry.value = value;
          next.overrides.push_back(entry);
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
void check_case(const StudyCase &one)
{
  try
  {
    const ParameterFile file(one.scene_file, one.overrides);
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
  for (int number = 1; number <= most_axes; ++number)
    if (const auto name = "Axis " + std::to_string(number); parameters.is_given(section, name))
      study.axes.push_back(read_axis(parameters, name));

  for (const auto &scene : read_list(parameters, "Scenes"))
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

  for (auto &one : study.cases)
  {
    one.overrides.push_back({"Output", "Directory", study.output_directory + "/" + one.name,
                             parameters.origin(section, "Output directory")});
    check_case(one);
  }
  return study;
}
} // namespace ricochet
