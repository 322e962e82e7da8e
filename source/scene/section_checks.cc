// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section_checks.h"

#include "error_list.h"

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

/// Returns whether all sections are known.
bool check_names(const ParameterFile &file, const std::vector<Section> &sections, ErrorList &errors)
{
  std::vector<std::string> known;
  for (const Section &section : sections)
    if (!section.name().empty())
      known.push_back(section.name());
  const std::size_t n_before = errors.size();
  for (const auto &section : file.sections())
    if (find_section(sections, section.name) == nullptr)
      errors.collect(
          [&]
          {
            throw InputError(section.origin + ": There is no section " + in_quotes(section.name) +
                             guess(section.name, known) + "\n  The sections are: " + joined(known) +
                             ".");
          });
  return errors.size() == n_before;
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

std::vector<std::string> missing_of(const Section &section, ErrorList &errors)
{
  std::vector<std::string> lines;
  for (const Entry &entry : section.entries())
    if (entry.is_required && !entry.is_given())
      lines.push_back(entry.example_line());
  for (const Choice &choice : section.choices())
    errors.collect(
        [&]
        {
          const auto more = missing_of(choice);
          lines.insert(lines.end(), more.begin(), more.end());
        });
  return lines;
}

/// An entry that the section does not have may be one that it misses, misspelt.
bool has_unknown_entry(const ParameterFile &file, const Section &section)
{
  return std::any_of(file.entries().begin(), file.entries().end(),
                     [&](const ParameterEntry &entry) {
                       return entry.section == section.name() &&
                              section.find(entry.name) == nullptr;
                     });
}

/// `all_known`: whether no section is misspelt.
void check_missing(const ParameterFile &file, const std::vector<Section> &sections,
                   const bool all_known, ErrorList &errors)
{
  std::string text;
  std::size_t n_missing = 0;
  for (const Section &section : sections)
  {
    const auto lines = missing_of(section, errors);
    if (lines.empty() || !all_known || has_unknown_entry(file, section))
      continue;
    n_missing += lines.size();
    const bool is_top = section.name().empty();
    text += is_top ? "" : "\n  subsection " + section.name();
    for (const auto &line : lines)
      text += (is_top ? "\n  " : "\n    ") + line;
    text += is_top ? "" : "\n  end";
  }
  if (n_missing == 0)
    return;
  errors.collect(
      [&]
      {
        throw InputError(file.path() + ": " +
                         (n_missing == 1 ? "An entry without a default is missing."
                                         : std::to_string(n_missing) +
                                               " entries without a default are missing.") +
                         " Add, with your own values:" + text +
                         (n_missing > 5 ? "\n  'ricochet template' prints a complete file." : ""));
      });
}
} // namespace

void read_sections(const ParameterFile &file, std::vector<Section> &sections)
{
  ErrorList errors;
  const bool all_known = check_names(file, sections, errors);
  for (const auto &entry : file.entries())
    if (entry.section.empty() || find_section(sections, entry.section) != nullptr)
      errors.collect([&] { check_value(entry, sections); });
  for (Section &section : sections)
    section.read(file);
  check_missing(file, sections, all_known, errors);
  errors.throw_if_any();
  for (const Section &section : sections)
    section.assign();
}

void read_and_check_sections(const ParameterFile &file, std::vector<Section> &sections)
{
  read_sections(file, sections);
  ErrorList errors;
  for (const Section &section : sections)
    section.run_checks(errors);
  errors.throw_if_any();
  for (const Section &section : sections)
    section.run_checks_with_others(errors);
  errors.throw_if_any();
}
} // namespace ricochet
