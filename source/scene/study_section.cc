// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_section.h"

#include "ricochet/scene/text_tools.h"
#include "scene_sections.h"
#include "study_axis.h"
#include "study_kind.h"
#include "study_limit.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
namespace
{
const Words<Combination> combinations{{Combination::all, "all"},
                                      {Combination::one_at_a_time, "one at a time"},
                                      {Combination::zipped, "zipped"}};

/// The parts of a list; an empty list has none. Empty parts are an error.
std::vector<std::string> list_of(const Entry &entry)
{
  if (entry.text().empty())
    return {};
  auto parts = split(entry.text(), ',');
  if (std::find(parts.begin(), parts.end(), "") != parts.end())
    entry.fail("The list has an empty place.", "Remove the comma too many.");
  return parts;
}

/// Entries that all cases share, "Section/Entry: value; Section/Entry: value".
std::vector<ParameterEntry> read_settings(const Entry &entry)
{
  std::vector<ParameterEntry> settings;
  if (entry.text().empty())
    return settings;
  for (const auto &part : split(entry.text(), ';'))
  {
    const auto colon = part.find(':');
    if (colon == std::string::npos || part.find('/') > colon)
      entry.fail(in_quotes(part) + " is no entry with its value.",
                 "Write 'Section/Entry: value; Section/Entry: value', for example "
                 "'Output/Pictures: false'.");
    settings.push_back(
        parse_override(part.substr(0, colon) + "=" + part.substr(colon + 1), origin_of(entry)));
  }
  return settings;
}

/// rows: the entries of the axes.
void read_ensemble(const Entry &entry, std::vector<StudyAxis> &axes, const Entries &rows)
{
  std::vector<std::string> names;
  for (const Entry *const row : rows)
    names.push_back(row->name);
  for (const auto &wanted : list_of(entry))
  {
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end())
      entry.fail(in_quotes(wanted) + " is no axis of this study.",
                 names.empty() ? "The study has no axis: add 'Axis 1', for example over "
                                 "'Time/Safety factor'."
                               : "Name one of " + joined(names, " or ") + ".");
    axes[found - names.begin()].is_ensemble = true;
  }
}

/// The name of the scene that the others are compared with, or "".
std::string read_reference(const Entry &reference, const Entry &ensemble,
                           const StudyParameters &study, const std::vector<std::string> &scenes)
{
  const std::string &text = reference.text();
  if (study.kind == StudyKind::convergence)
    return ""; // its reference is a value of an axis
  if (text.empty())
  {
    if (ensemble.is_given())
      ensemble.fail("There is no reference to compare ensembles with.",
                    "Name one of the scenes: 'set Reference = " + scenes.front() + "'.");
    return "";
  }
  if (std::find(scenes.begin(), scenes.end(), text) == scenes.end())
    reference.fail(in_quotes(text) + " is not among the scenes.",
                   "Write it as it stands in 'Scenes': " + joined(scenes, " or ") + ".");
  if (scenes.size() < 2)
    reference.fail("There is nothing to compare with it.", "Add another scene to 'Scenes'.");
  if (study.combination == Combination::one_at_a_time)
    reference.fail("Cases are compared under the same values of all axes, but the axes are varied "
                   "one at a time.",
                   "Remove 'Combine', or the reference.");
  return scene_name(text);
}

/// All axes must have as many values as the first.
void check_zipped(const Entries &entries, const std::vector<StudyAxis> &axes)
{
  for (std::size_t a = 1; a < axes.size(); ++a)
    if (axes[a].values.size() != axes[0].values.size())
      entries[a]->fail("It has " + std::to_string(axes[a].values.size()) + " values, but " +
                           in_quotes(entries[0]->name) + " has " +
                           std::to_string(axes[0].values.size()) +
                           ", and 'Combine = zipped' takes them side by side.",
                       "Give all axes equally many values.");
}

/// The entries Axis 1 to Axis most_axes.
Entries add_axes(Section &in)
{
  Entries axes;
  for (int i = 0; i < most_axes; ++i)
    axes.push_back(&in.optional(
        "Axis " + std::to_string(i + 1), unbound_text("Section/Entry: value | value"),
        "Plate 1/Grid spacing: 1.5 mm | 1.0 mm",
        "An entry of the scenes and the values it takes; several entries, with commas between "
        "them, take the same value or one each: 'value; value | value; value'. A range, 'value to "
        "value step value', stands for its members. '= 4 * Axis 1' follows another axis"));
  return axes;
}

/// The axes that are given, and the entries of those that are not derived.
Entries read_axes(const Entries &rows, std::vector<StudyAxis> &axes)
{
  Entries given;
  for (const Entry *const row : rows)
    if (row->is_given() && !is_derived(*row))
    {
      axes.push_back(read_axis(*row));
      given.push_back(row);
    }
  for (const Entry *const row : rows)
    if (row->is_given() && is_derived(*row))
      derive_axis(*row, given, axes);
  return given;
}

struct ComparisonRows
{
  const Entry *reference, *ensemble;
};

ComparisonRows add_comparison(Section &in)
{
  const Entry &reference = in.optional(
      "Reference", unbound_text("one of the scenes"), "base.prm",
      "The scene that the others are compared with, under the same values of the axes: outcome, "
      "path, exit speed, cost. With 'Kind = convergence' a value of 'Axis 1'");
  const Entry &ensemble =
      in.optional("Ensemble", unbound_text("axes separated by commas"), "Axis 2",
                  "With a reference: axes that only repeat a run, for its scatter; runs that "
                  "differ in them alone are taken together");
  return {&reference, &ensemble};
}
} // namespace

std::string scene_name(const std::string &scene)
{
  return file_name_of(std::filesystem::path(scene).stem().string());
}

Section study_section(const std::string &stem, StudyParameters &study, StudySettings &settings)
{
  Section in(study_name, "Several runs: every scene with the axes' values.");
  in.named_after_file("Title", text(study.title, "any text"), stem, "A study",
                      "What the study is called in its results, by default like the file");
  settings.scenes_row = &in.required(
      "Scenes", unbound_text("parameter files separated by commas, relative to this file"),
      "base.prm", "The scenes to run");
  settings.directory_row = &in.named_after_file(
      "Output directory",
      text(study.output_directory, "a folder, relative to where the program is started"),
      "output/" + stem, "output/study",
      "Where the results go, one folder per case; by default output/ and the file's name");
  const Entry &columns = in.optional(
      "Columns", unbound_text("names of columns separated by commas"), "outcome, exit_speed_m_s",
      "Columns of the table of results: entries of summary.json");
  in.with_default(
      "Combine", choice(study.combination, combinations), "all",
      "Whether all combinations of the axes' values are run; or each scene as it is and "
      "then with one value of one axis at a time; or the first values of all axes "
      "together, then the second ones");
  const Entry &shared = in.optional(
      "Settings", unbound_text("Section/Entry: value; Section/Entry: value"),
      "Output/Pictures: false; Output/ParaView files: false", "Entries that all cases share");
  const Entry &data =
      in.optional("Reference data", unbound_text("a CSV file, relative to this file"),
                  "experiment.csv", "Like 'Output/Reference data' in all cases");
  const auto comparison = add_comparison(in);
  const Entry &kind     = add_kind(in, study);
  const auto limit      = add_limit(in);
  in.with_default("Pictures", flag(study.pictures), "true",
                  "Whether a comparison of the first eight cases is drawn at the end; with a "
                  "reference also a chart of accuracy against cost");
  in.with_default("Report", flag(study.report), "true",
                  "Whether report.html is written at the end: all cases, charts, tables, pictures");
  const auto axes = add_axes(in);

  in.check(
      [&study, &settings, &columns, &shared, &data, &kind, comparison, limit, axes]
      {
        study.columns        = list_of(columns);
        study.columns_origin = columns.origin();
        const auto given     = read_axes(axes, study.axes);
        settings.scenes      = list_of(*settings.scenes_row);
        settings.overrides   = read_settings(shared);
        if (data.is_given())
          settings.overrides.push_back({"Output", "Reference data", data.text(), origin_of(data)});
        study.reference =
            read_reference(*comparison.reference, *comparison.ensemble, study, settings.scenes);
        if (study.combination == Combination::zipped)
          check_zipped(given, study.axes);
        read_ensemble(*comparison.ensemble, study.axes, given);
        read_limit(limit, study);
        check_kind(kind, *comparison.reference, study);
      });
  return in;
}
} // namespace ricochet
