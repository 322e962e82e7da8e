// SPDX-License-Identifier: LGPL-2.1-or-later
// A section of a parameter file. Each entry is one row: its name, the variable that takes its value
// with what the value has to look like, an example, and what it means. The row is all that reading,
// checks, error messages, used.prm, the template and the schema know of the entry.
//
//   Section time_section(TimeParameters &time)
//   {
//     Section in("Time", "How long and in which steps.");
//     in.required("Final time", quantity(time.end_time, Dimension::time, Limit::positive),
//                 "450 us", "The run ends here at the latest");
//     const Entry &safety = in.with_default("Safety factor", ...);
//     in.check([&] { if (time.safety_factor > 1.) safety.fail(...); });
//     return in;
//   }
#pragma once

#include "bindings.h"
#include "error_list.h"
#include "ricochet/scene/parameter_file.h"

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
/// One entry: its declaration, and what a file says about it.
class Entry
{
public:
  std::string section; // "" for the entries at the top
  std::string name;
  std::shared_ptr<const EntryPattern> pattern;
  bool is_required;
  std::string default_value; // "" if there is none
  std::string example;       // a value that makes sense, with its unit
  std::string documentation; // half a sentence; the pattern completes it

  /// Whether the file or an override sets the entry to a value (that is not empty).
  bool is_given() const { return !given_.empty(); }

  /// The value or its default, as it is written.
  const std::string &text() const { return is_given() ? given_ : default_value; }

  /// "prm/base.prm:12", or the file alone for an entry that is not given.
  const std::string &origin() const { return origin_; }

  /// "Plate 1/Grid spacing"
  std::string path() const;

  /// "set Grid spacing = 1.5 mm", to be added to a file.
  std::string example_line() const { return "set " + name + " = " + example; }

  /// Throws InputError about the value: "origin: Section/Name = 'value': what", remedy.
  [[noreturn]] void fail(const std::string &what, const std::string &remedy) const;

private:
  friend class Section;
  std::string given_, origin_;
  std::vector<std::function<void(const std::string &)>> assign_;
};

/// Where the file lies that the text of an entry names: names are relative to the parameter file
/// that gives them, those of the command line to where the program is started.
std::string path_of_file(const Entry &entry, const std::string &name);

using Entries = std::vector<const Entry *>;

/// That an entry of the section is given and says one of the words; without entry always true.
struct Condition
{
  const Entry *entry             = nullptr;
  std::vector<std::string> words = {};

  bool holds() const;
};

/// Exactly one of the options, each a group of entries, must be given if the condition holds.
struct Choice
{
  std::vector<Entries> options;
  Condition condition;

  /// Number of the option of which an entry is given, the number of options if there is none.
  /// Throws InputError if entries of two are given.
  std::size_t option_given() const;
};

class Section
{
public:
  /// documentation: one or two sentences, for the template.
  Section(std::string name, std::string documentation);
  Section(Section &&)            = default; // entries stay where they are
  Section &operator=(Section &&) = default;

  // The rows. The reference lasts as long as the section, also if that is moved. A second row of
  // the same name binds another variable to the entry that is there.
  Entry &required(const std::string &name, const Binding &binding, const std::string &example,
                  const std::string &documentation);
  Entry &with_default(const std::string &name, const Binding &binding, const std::string &value,
                      const std::string &documentation);
  Entry &optional(const std::string &name, const Binding &binding, const std::string &example,
                  const std::string &documentation);
  /// With a default that is not the example, because it depends on the file's name.
  Entry &named_after_file(const std::string &name, const Binding &binding, const std::string &value,
                          const std::string &example, const std::string &documentation);

  void one_of(std::vector<Entries> options, const Condition &condition = {});
  void all_of(const Entries &entries, const Condition &condition = {})
  {
    one_of({entries}, condition);
  }

  /// What holds between entries of the section, and what follows from them: called after all
  /// sections have been read, section by section.
  void check(std::function<void()> action) { checks_.push_back(std::move(action)); }

  /// What holds between this section and others: called after those.
  void check_with_others(std::function<void()> action)
  {
    checks_with_others_.push_back(std::move(action));
  }

  const std::string &name() const { return name_; }
  const std::string &documentation() const { return documentation_; }
  const std::deque<Entry> &entries() const { return entries_; }
  const std::vector<Choice> &choices() const { return choices_; }
  const Entry *find(const std::string &name) const;
  std::vector<std::string> entry_names() const;
  /// Length of the longest name, for columns.
  std::size_t longest_name() const;
  /// Those that the entry has a part in.
  std::vector<const Choice *> choices_with(const Entry &entry) const;

  /// Takes over what the file says; its values must match their patterns.
  void read(const ParameterFile &file);
  /// Gives the variables their values or defaults; those without either keep what they have.
  void assign() const;
  // Every check, whatever the others find.
  void run_checks(ErrorList &errors) const;
  void run_checks_with_others(ErrorList &errors) const;

private:
  Entry &add(const std::string &name, const Binding &binding, const std::string &documentation);

  std::string name_, documentation_;
  std::deque<Entry> entries_; // a deque never moves its elements
  std::vector<Choice> choices_;
  std::vector<std::function<void()>> checks_, checks_with_others_;
};

/// "entry is given and says one of these": the words of a table for some of its values.
template <class T>
Condition when(const Entry &entry, const Words<T> &words, const std::vector<T> &values)
{
  Condition condition{&entry};
  for (const T &value : values)
    condition.words.push_back(name_of(words, value));
  return condition;
}
} // namespace ricochet
