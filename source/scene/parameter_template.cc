// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/parameter_template.h"

#include "parameter_writer.h"
#include "ricochet/scene/text_tools.h"
#include "scene_sections.h"
#include "schema.h"
#include "study_section.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace ricochet
{
namespace
{
/// All kinds of parameter files with their sections, and what these are bound to.
class Kinds
{
public:
  struct Kind
  {
    std::string file, introduction;
    std::vector<Section> sections;
  };

  /// stem: name of the file in the defaults that depend on it.
  explicit Kinds(const std::string &stem) : scene_(empty_scene(1, {"PMMA"}))
  {
    kinds.push_back({"scene",
                     "Parameters of an oblique impact. Every value carries its unit; everything "
                     "after a # is a comment. An entry behind a # has a default, stands for the "
                     "one before it, or belongs to another choice. Axes: x along the plate and "
                     "the flight, y across, z up.",
                     scene_sections(stem, scene_)});
    std::vector<Section> study;
    study.push_back(study_section(stem, study_, settings_));
    kinds.push_back({"study",
                     "A study is a file of its own: the lines below without '# ' at their "
                     "beginning. It is run with 'ricochet study'.",
                     std::move(study)});
    kinds.push_back({"stability",
                     "A stability experiment, too, is a file of its own: the lines below without "
                     "'# ' at their beginning. It is run with 'ricochet run'.",
                     stability_sections(stem, experiment_)});
  }
  Kinds(const Kinds &)            = delete; // the sections are bound to the members
  Kinds &operator=(const Kinds &) = delete;

  std::vector<Kind> kinds;

private:
  Scene scene_;
  StudyParameters study_{};
  StudySettings settings_;
  StabilityParameters experiment_;
};

bool is_among(const Entry &entry, const Entries &entries)
{
  return std::find(entries.begin(), entries.end(), &entry) != entries.end();
}

/// Whether the rule holds for the examples of the template.
bool holds_in_template(const Condition &condition)
{
  const auto &words = condition.words;
  return condition.entry == nullptr ||
         std::find(words.begin(), words.end(), condition.entry->example) != words.end();
}

/// Whether some rule asks for the entry if the examples are taken: it is in the first option.
bool is_asked_for(const Section &section, const Entry &entry)
{
  for (const Choice *const choice : section.choices_with(entry))
    if (holds_in_template(choice->condition) && is_among(entry, choice->options.front()))
      return true;
  return false;
}

/// " Required if 'Nose shape' is ogive or cone.", or "".
std::string condition_text(const Section &section, const Entry &entry)
{
  const Entry *condition = nullptr;
  std::vector<std::string> words;
  for (const Choice *const choice : section.choices_with(entry))
    if (choice->condition.entry != nullptr && is_among(entry, choice->options.front()))
    {
      condition = choice->condition.entry;
      words.insert(words.end(), choice->condition.words.begin(), choice->condition.words.end());
    }
  return condition == nullptr
             ? ""
             : " Required if " + in_quotes(condition->name) + " is " + joined(words, " or ") + ".";
}

void write_entry(const Section &section, const Entry &entry, const std::string &indent,
                 const std::size_t width, std::ostream &out)
{
  write_comment(entry.documentation + ": " + entry.pattern->expected() + "." +
                    condition_text(section, entry),
                indent, width, out);
  const bool has_own_default = !entry.default_value.empty() && entry.default_value == entry.example;
  const bool is_asked        = entry.is_required || is_asked_for(section, entry);
  out << indent << (is_asked || has_own_default ? "set " : "# set ")
      << padded(entry.name, section.longest_name()) << " = " << entry.example
      << (is_asked ? " # required" : "") << '\n';
}

void write_template(const std::vector<Section> &sections, const std::size_t width,
                    std::ostream &out)
{
  for (const Section &section : sections)
  {
    const bool is_top = section.name().empty();
    if (!is_top)
    {
      out << '\n';
      write_comment(section.documentation(), "", width, out);
      out << "subsection " << section.name() << '\n';
    }
    for (const Entry &entry : section.entries())
      write_entry(section, entry, is_top ? "" : "  ", width, out);
    out << (is_top ? "" : "end\n");
  }
}
} // namespace

void print_template(std::ostream &out)
{
  constexpr std::size_t width = 100; // of a line
  const std::string mark      = "# ";
  const Kinds all("template");
  for (const auto &kind : all.kinds)
  {
    const bool is_first = &kind == &all.kinds.front();
    out << (is_first ? "" : "\n\n");
    write_comment(kind.introduction, "", width, out);
    out << (kind.sections.front().name().empty() ? "\n" : ""); // others begin with an empty line
    if (is_first)
    {
      write_template(kind.sections, width, out);
      continue;
    }
    std::stringstream text;
    write_template(kind.sections, width - mark.size(), text);
    for (std::string line; std::getline(text, line);)
      out << (line.empty() ? "" : mark) << line << '\n';
  }
}

void print_schema(std::ostream &out)
{
  nlohmann::ordered_json schema{{"sections", nlohmann::ordered_json::array()},
                                {"entries", nlohmann::ordered_json::array()}};
  const Kinds all("<file>");
  for (const auto &kind : all.kinds)
    for (const Section &section : kind.sections)
    {
      schema["sections"].push_back(describe_section(section, kind.file));
      for (const Entry &entry : section.entries())
        schema["entries"].push_back(describe_entry(section, entry, kind.file));
    }
  out << schema.dump(1) << '\n';
}
} // namespace ricochet
