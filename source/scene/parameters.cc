// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameters.h"

#include "ricochet/base/exceptions.h"
#include "text_tools.h"

#include <algorithm>

namespace ricochet
{
namespace
{
std::string path_name(const std::string &section, const std::string &name)
{
  return section.empty() ? name : section + "/" + name;
}

std::vector<std::string> entry_names(const SectionDeclaration &section)
{
  std::vector<std::string> names;
  for (const auto &entry : section.entries)
    names.push_back(entry.name);
  return names;
}

std::vector<std::string> section_names(const std::vector<SectionDeclaration> &sections)
{
  std::vector<std::string> names;
  for (const auto &section : sections)
    if (!section.name.empty())
      names.push_back(section.name);
  return names;
}

/// Lines to add to a file, one for every missing entry of a section.
class MissingEntries
{
public:
  explicit MissingEntries(const SectionDeclaration &section) : section_(section) {}

  void add(const std::string &name, const std::string &remark = "")
  {
    const std::string line = "set " + name + " = " + declaration(name).example;
    lines_.push_back(remark.empty() ? line : line + "   # " + remark);
  }

  /// "or: set Density = 7850 kg/m3", what may be added instead of the first option.
  std::string alternatives(const Choice &choice) const
  {
    std::vector<std::string> lines;
    for (std::size_t i = 1; i < choice.options.size(); ++i)
      for (const auto &name : choice.options[i])
        lines.push_back("set " + name + " = " + declaration(name).example);
    return lines.empty() ? "" : "or: " + joined(lines);
  }

  std::size_t size() const { return lines_.size(); }

  std::string text() const
  {
    const std::string indent = section_.name.empty() ? "  " : "    ";
    std::string result;
    for (const auto &line : lines_)
      result += "\n" + indent + line;
    if (section_.name.empty() || lines_.empty())
      return result;
    return "\n  subsection " + section_.name + result + "\n  end";
  }

private:
  const EntryDeclaration &declaration(const std::string &name) const
  {
    return *std::find_if(section_.entries.begin(), section_.entries.end(),
                         [&](const auto &entry) { return entry.name == name; });
  }

  const SectionDeclaration &section_;
  std::vector<std::string> lines_;
};
} // namespace

Parameters::Parameters(const ParameterFile &file, std::vector<SectionDeclaration> sections) :
  path_(file.path()), sections_(std::move(sections))
{
  for (const auto &section : sections_)
  {
    if (!section.name.empty())
      handler_.enter_subsection(section.name);
    for (const auto &entry : section.entries)
      handler_.declare_entry(entry.name, entry.default_value, *entry.pattern,
                             entry.documentation + ": " + entry.pattern->expected() + ".");
    if (!section.name.empty())
      handler_.leave_subsection();
  }

  check_sections(file);
  for (const auto &entry : file.entries())
  {
    check_value(entry);
    if (!entry.value.empty())
      given_.push_back(entry);
  }
  check_missing();

  for (const auto &entry : given_)
  {
    if (!entry.section.empty())
      handler_.enter_subsection(entry.section);
    handler_.set(entry.name, entry.value);
    if (!entry.section.empty())
      handler_.leave_subsection();
  }
}

const SectionDeclaration *Parameters::find_section(const std::string &name) const
{
  for (const auto &section : sections_)
    if (section.name == name)
      return &section;
  return nullptr;
}

const EntryDeclaration *Parameters::find_entry(const std::string &section,
                                               const std::string &name) const
{
  if (const SectionDeclaration *const declaration = find_section(section))
    for (const auto &entry : declaration->entries)
      if (entry.name == name)
        return &entry;
  return nullptr;
}

const ParameterEntry *Parameters::given(const std::string &section, const std::string &name) const
{
  for (const auto &entry : given_)
    if (entry.section == section && entry.name == name)
      return &entry;
  return nullptr;
}

void Parameters::check_sections(const ParameterFile &file) const
{
  const auto known = section_names(sections_);
  for (const auto &section : file.sections())
    if (find_section(section.name) == nullptr)
      throw InputError(section.origin + ": There is no section " + in_quotes(section.name) +
                       guess(section.name, known) + "\n  The sections are: " + joined(known) + ".");
}

void Parameters::check_value(const ParameterEntry &entry) const
{
  const EntryDeclaration *const declaration = find_entry(entry.section, entry.name);
  if (declaration == nullptr)
    fail_unknown_entry(entry);
  if (entry.value.empty())
    return;
  const std::string problem = declaration->pattern->problem(entry.value);
  if (problem.empty())
    return;
  const std::string expected = declaration->pattern->expected();
  const bool is_clear        = expected.find(declaration->example) != std::string::npos;
  throw InputError(entry.origin + ": " + path_name(entry.section, entry.name) + " = " +
                   in_quotes(entry.value) + ": " + problem + "\n  Expected: " + expected +
                   (is_clear ? "." : ", for example '" + declaration->example + "'."));
}

void Parameters::fail_unknown_entry(const ParameterEntry &entry) const
{
  const SectionDeclaration &section = *find_section(entry.section);
  const auto known                  = entry_names(section);
  std::string hint                  = guess(entry.name, known);

  // The right entry in the wrong section is a better guess than a similar name in this one.
  std::vector<std::string> homes;
  for (const auto &other : sections_)
    for (const auto &name : entry_names(other))
      if (lower_case(name) == lower_case(entry.name) && &other != &section)
        homes.push_back(path_name(other.name, name));
  if (!homes.empty() && lower_case(nearest(entry.name, known)) != lower_case(entry.name))
    hint = "; did you mean '" + joined(homes, "' or '") + "'?";

  throw InputError(entry.origin + ": There is no entry " + in_quotes(entry.name) +
                   (entry.section.empty() ? " outside the sections"
                                          : " in the section " + in_quotes(entry.section)) +
                   hint + "\n  The entries there are: " + joined(known) + ".");
}

void Parameters::check_missing() const
{
  std::string text;
  std::size_t n_missing = 0;
  for (const auto &section : sections_)
  {
    MissingEntries missing(section);
    for (const auto &entry : section.entries)
      if (entry.presence == Presence::required && !is_given(section.name, entry.name))
        missing.add(entry.name);
    for (const auto &choice : section.choices)
      if (applies(choice, section.name))
      {
        const std::size_t option = option_given(choice, section.name);
        const bool none          = option == choice.options.size();
        std::string remark       = none ? missing.alternatives(choice) : "";
        for (const auto &name : choice.options[none ? 0 : option])
          if (!is_given(section.name, name))
          {
            missing.add(name, remark);
            remark.clear();
          }
      }
    n_missing += missing.size();
    text += missing.text();
  }
  if (n_missing > 0)
    throw InputError(path_ + ": " +
                     (n_missing == 1
                          ? "An entry without a default is missing."
                          : std::to_string(n_missing) + " entries without a default are missing.") +
                     " Add, with your own values:" + text +
                     (n_missing > 5 ? "\n  'ricochet template' prints a complete file." : ""));
}

bool Parameters::applies(const Choice &choice, const std::string &section) const
{
  if (choice.entry.empty())
    return true;
  const auto &values                    = choice.values;
  const ParameterEntry *const condition = given(section, choice.entry);
  return condition != nullptr &&
         std::find(values.begin(), values.end(), condition->value) != values.end();
}

std::size_t Parameters::option_given(const Choice &choice, const std::string &section) const
{
  const ParameterEntry *first = nullptr;
  std::size_t option          = choice.options.size();
  for (std::size_t i = 0; i < choice.options.size(); ++i)
    for (const auto &name : choice.options[i])
      if (const ParameterEntry *const entry = given(section, name))
      {
        if (first != nullptr && option != i)
          throw InputError(entry->origin + ": " + in_quotes(path_name(section, name)) +
                           " is given, but so is " + in_quotes(first->name) + " (" + first->origin +
                           ").\n  Keep one of them; a line without a value, 'set " + first->name +
                           " =', takes an included one back.");
        first  = entry;
        option = i;
      }
  return option;
}

bool Parameters::is_given(const std::string &section, const std::string &name) const
{
  return given(section, name) != nullptr;
}

std::string Parameters::text(const std::string &section, const std::string &name) const
{
  if (section.empty())
    return handler_.get(name);
  return handler_.get({section}, name);
}

bool Parameters::flag(const std::string &section, const std::string &name) const
{
  return text(section, name) == "true";
}

std::vector<double> Parameters::quantities(const std::string &section,
                                           const std::string &name) const
{
  const std::string value = text(section, name);
  if (value.empty())
    return {0.};
  const auto &pattern = *find_entry(section, name)->pattern;
  return dynamic_cast<const QuantityPattern &>(pattern).values(value);
}

double Parameters::quantity(const std::string &section, const std::string &name) const
{
  return quantities(section, name).front();
}

std::string Parameters::origin(const std::string &section, const std::string &name) const
{
  const ParameterEntry *const entry = given(section, name);
  return entry == nullptr ? path_ : entry->origin;
}

void Parameters::fail(const std::string &section, const std::string &name, const std::string &what,
                      const std::string &remedy) const
{
  throw InputError(origin(section, name) + ": " + path_name(section, name) + " = " +
                   in_quotes(text(section, name)) + ": " + what + "\n  " + remedy);
}
} // namespace ricochet
