// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <filesystem>

namespace ricochet
{
std::string Entry::path() const
{
  return entry_path(section, name);
}

void Entry::fail(const std::string &what, const std::string &remedy) const
{
  throw InputError(origin() + ": " + path() + " = " + in_quotes(text()) + ": " + what + "\n  " +
                   remedy);
}

std::string path_of_file(const Entry &entry, const std::string &name)
{
  const std::filesystem::path path = name;
  const auto colon                 = entry.origin().rfind(':');
  return !entry.is_given() || path.is_absolute() || colon == std::string::npos
             ? name
             : (std::filesystem::path(entry.origin().substr(0, colon)).parent_path() / path)
                   .lexically_normal()
                   .string();
}

bool Condition::holds() const
{
  return entry == nullptr ||
         (entry->is_given() && std::find(words.begin(), words.end(), entry->text()) != words.end());
}

std::size_t Choice::option_given() const
{
  const Entry *first = nullptr;
  std::size_t option = options.size();
  for (std::size_t i = 0; i < options.size(); ++i)
    for (const Entry *const entry : options[i])
    {
      if (!entry->is_given())
        continue;
      if (first != nullptr && option != i)
        throw InputError(entry->origin() + ": " + in_quotes(entry->path()) +
                         " is given, but so is " + in_quotes(first->name) + " (" + first->origin() +
                         ").\n  Keep one of them; a line without a value, 'set " + first->name +
                         " =', takes an included one back.");
      first  = entry;
      option = i;
    }
  return option;
}

Section::Section(std::string name, std::string documentation) :
  name_(std::move(name)), documentation_(std::move(documentation))
{
}

Entry &Section::add(const std::string &name, const Binding &binding,
                    const std::string &documentation)
{
  for (Entry &present : entries_)
    if (present.name == name)
    {
      present.assign_.push_back(binding.assign);
      return present;
    }
  Entry &entry        = entries_.emplace_back();
  entry.section       = name_;
  entry.name          = name;
  entry.pattern       = binding.pattern;
  entry.is_required   = false;
  entry.documentation = documentation;
  entry.assign_.push_back(binding.assign);
  return entry;
}

Entry &Section::required(const std::string &name, const Binding &binding,
                         const std::string &example, const std::string &documentation)
{
  Entry &entry      = optional(name, binding, example, documentation);
  entry.is_required = true;
  return entry;
}

Entry &Section::with_default(const std::string &name, const Binding &binding,
                             const std::string &value, const std::string &documentation)
{
  return named_after_file(name, binding, value, value, documentation);
}

Entry &Section::optional(const std::string &name, const Binding &binding,
                         const std::string &example, const std::string &documentation)
{
  return named_after_file(name, binding, "", example, documentation);
}

Entry &Section::named_after_file(const std::string &name, const Binding &binding,
                                 const std::string &value, const std::string &example,
                                 const std::string &documentation)
{
  Entry &entry        = add(name, binding, documentation);
  entry.default_value = value;
  entry.example       = example;
  return entry;
}

void Section::one_of(std::vector<Entries> options, const Condition &condition)
{
  choices_.push_back({std::move(options), condition});
}

const Entry *Section::find(const std::string &name) const
{
  for (const Entry &entry : entries_)
    if (entry.name == name)
      return &entry;
  return nullptr;
}

std::vector<std::string> Section::entry_names() const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    names.push_back(entry.name);
  return names;
}

std::size_t Section::longest_name() const
{
  std::size_t longest = 0;
  for (const Entry &entry : entries_)
    longest = std::max(longest, entry.name.size());
  return longest;
}

std::vector<const Choice *> Section::choices_with(const Entry &entry) const
{
  std::vector<const Choice *> found;
  for (const Choice &choice : choices_)
    if (std::any_of(choice.options.begin(), choice.options.end(),
                    [&](const Entries &option)
                    { return std::find(option.begin(), option.end(), &entry) != option.end(); }))
      found.push_back(&choice);
  return found;
}

void Section::read(const ParameterFile &file)
{
  for (Entry &entry : entries_)
  {
    entry.given_.clear();
    entry.origin_ = file.path();
    for (const ParameterEntry &found : file.entries())
      if (found.section == name_ && found.name == entry.name && !found.value.empty())
      {
        entry.given_  = found.value;
        entry.origin_ = found.origin;
      }
  }
}

void Section::assign() const
{
  for (const Entry &entry : entries_)
    if (!entry.text().empty())
      for (const auto &assign : entry.assign_)
        assign(entry.text());
}

void Section::run_checks(ErrorList &errors) const
{
  for (const auto &check : checks_)
    errors.collect(check);
}

void Section::run_checks_with_others(ErrorList &errors) const
{
  for (const auto &check : checks_with_others_)
    errors.collect(check);
}
} // namespace ricochet
