// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section_checks.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>

namespace ricochet
{
namespace
{
const Section *find_section(const std::vector<Section> &sections, const std::string &name)
{
  for (const Section &section : sections)
    if (section.name() == name)
      return &section;
  return nullptr;
}

void check_names(const ParameterFile &file, const std::vector<Section> &sections)
{
  std::vector<std::string> known;
  for (const Section &section : sections)
    if (!section.name().empty())
      known.push_back(section.name());
  for (const auto &section : file.sections())
    if (find_section(sections, section.name) == nullptr)
      throw InputError(section.origin + ": There is no section " + in_quotes(section.name) +
                       guess(section.name, known) + "\n  The sections are: " + joined(known) + ".");
}

[[noreturn]] void fail_unknown_entry(const ParameterEntry &entry,
                                     const std::vector<Section> &sections)
{
  const Section *const section =
      find_section(sections, entry.section); // none at the top of a study
  const auto known = section != nullptr ? section->entry_names() : std::vector<std::string>();
  std::string hint = guess(entry.name, known);

  // The right entry in the wrong section is a better guess than a similar name in this one.
  std::vector<std::string> homes;
  for (const Section &other : sections)
    for (const auto &name : other.entry_names())
      if (lower_case(name) == lower_case(entry.name) && &other != section)
        homes.push_back(entry_path(other.name(), name));
  if (!homes.empty() && lower_case(nearest(entry.name, known)) != lower_case(entry.name))
    hint = "; did you mean '" + joined(homes, "' or '") + "'?";

  throw InputError(entry.origin + ": There is no entry " + in_quotes(entry.name) +
                   (entry.section.empty() ? " outside the sections"
                                          : " in the section " + in_quotes(entry.section)) +
                   hint +
                   (known.empty() ? "\n  All entries stand in sections."
                                  : "\n  The entries there are: " + joined(known) + "."));
}

void check_value(const ParameterEntry &given, const std::vector<Section> &sections)
{
  const Section *const section = find_section(sections, given.section);
  const Entry *const entry     = section != nullptr ? section->find(given.name) : nullptr;
  if (entry == nullptr)
    fail_unknown_entry(given, sections);
  const std::string problem = given.value.empty() ? "" : entry->pattern->problem(given.value);
  if (problem.empty())
    return;
  const std::string expected = entry->pattern->expected();
  const bool is_clear        = expected.find(entry->example) != std::string::npos;
  throw InputError(given.origin + ": " + entry->path() + " = " + in_quotes(given.value) + ": " +
                   problem + "\n  Expected: " + expected +
                   (is_clear ? "." : ", for example '" + entry->example + "'."));
}

/// "or: set Density = 7850 kg/m3", what may be added instead of the first option.
std::string alternatives(const Choice &choice)
{
  std::vector<std::string> lines;
  for (std::size_t i = 1; i < choice.options.size(); ++i)
    for (const Entry *const entry : choice.options[i])
      lines.push_back(entry->example_line());
  return lines.empty() ? "" : "or: " + joined(lines);
}

/// Lines to add for what is missing of one choice, beside the entries of an option that are there.
std::vector<std::string> missing_of(const Choice &choice)
{
  std::vector<std::string> lines;
  if (!choice.condition.holds())
    return lines;
  const std::size_t option = choice.option_given();
  const bool none          = option == choice.options.size();
  std::string remark       = none ? alternatives(choice) : "";
  for (const Entry *const entry : choice.options[none ? 0 : option])
    if (!entry->is_given())
    {
      lines.push_back(entry->example_line() + (remark.empty() ? "" : "   # " + remark));
      remark.clear();
    }
  return lines;
}

std::vector<std::string> missing_of(const Section &section)
{
  std::vector<std::string> lines;
  for (const Entry &entry : section.entries())
    if (entry.is_required && !entry.is_given())
      lines.push_back(entry.example_line());
  for (const Choice &choice : section.choices())
  {
    const auto more = missing_of(choice);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

void check_missing(const ParameterFile &file, const std::vector<Section> &sections)
{
  std::string text;
  std::size_t n_missing = 0;
  for (const Section &section : sections)
  {
    const auto lines = missing_of(section);
    if (lines.empty())
      continue;
    n_missing += lines.size();
    const bool is_top = section.name().empty();
    text += is_top ? "" : "\n  subsection " + section.name();
    for (const auto &line : lines)
      text += (is_top ? "\n  " : "\n    ") + line;
    text += is_top ? "" : "\n  end";
  }
  if (n_missing > 0)
    throw InputError(file.path() + ": " +
                     (n_missing == 1
                          ? "An entry without a default is missing."
                          : std::to_string(n_missing) + " entries without a default are missing.") +
                     " Add, with your own values:" + text +
                     (n_missing > 5 ? "\n  'ricochet template' prints a complete file." : ""));
}
} // namespace

void read_sections(const ParameterFile &file, std::vector<Section> &sections)
{
  check_names(file, sections);
  for (const auto &entry : file.entries())
    check_value(entry, sections);
  for (Section &section : sections)
    section.read(file);
  check_missing(file, sections);
  for (const Section &section : sections)
    section.assign();
}

void read_and_check_sections(const ParameterFile &file, std::vector<Section> &sections)
{
  read_sections(file, sections);
  for (const Section &section : sections)
    section.run_checks();
  for (const Section &section : sections)
    section.run_checks_with_others();
}
} // namespace ricochet
