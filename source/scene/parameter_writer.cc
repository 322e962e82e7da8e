// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameter_writer.h"

#include "text_tools.h"

#include <algorithm>
#include <ostream>

namespace ricochet
{
namespace
{
std::string padded(std::string text, const std::size_t width)
{
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::size_t longest_name(const Section &section)
{
  std::size_t longest = 0;
  for (const Entry &entry : section.entries())
    longest = std::max(longest, entry.name.size());
  return longest;
}

/// The text as comment lines of at most 100 characters.
void write_comment(const std::string &text, const std::string &indent, std::ostream &out)
{
  constexpr std::size_t width = 100;
  std::string line            = indent + "#";
  for (const auto &word : split(text, ' '))
  {
    if (line.size() + 1 + word.size() > width)
    {
      out << line << '\n';
      line = indent + "#";
    }
    line += " " + word;
  }
  out << line << '\n';
}

bool is_among(const Entry &entry, const Entries &entries)
{
  return std::find(entries.begin(), entries.end(), &entry) != entries.end();
}

/// Whether the entry belongs to the second or a later option of a choice.
bool is_alternative(const Section &section, const Entry &entry)
{
  for (const Choice &choice : section.choices())
    for (std::size_t i = 1; i < choice.options.size(); ++i)
      if (is_among(entry, choice.options[i]))
        return true;
  return false;
}

/// Whether nothing happens without the entry: no default, and no choice asks for it.
bool is_extra(const Section &section, const Entry &entry)
{
  if (entry.is_required || !entry.default_value.empty())
    return false;
  for (const Choice &choice : section.choices())
    for (const Entries &option : choice.options)
      if (is_among(entry, option))
        return false;
  return true;
}

void write_template(const Section &section, std::ostream &out)
{
  const std::string indent = section.name().empty() ? "" : "  ";
  if (!section.name().empty())
  {
    out << '\n';
    write_comment(section.documentation(), "", out);
    out << "subsection " << section.name() << '\n';
  }
  for (const Entry &entry : section.entries())
  {
    write_comment(entry.documentation + ": " + entry.pattern->expected() + ".", indent, out);
    const bool named_after_file =
        !entry.default_value.empty() && entry.default_value != entry.example;
    const bool commented_out =
        named_after_file || is_alternative(section, entry) || is_extra(section, entry);
    out << indent << (commented_out ? "# set " : "set ")
        << padded(entry.name, longest_name(section)) << " = " << entry.example << '\n';
  }
  if (!section.name().empty())
    out << "end\n";
}
} // namespace

void write_parameters(const std::vector<Section> &sections, std::ostream &out)
{
  for (const Section &section : sections)
  {
    const std::string indent = section.name().empty() ? "" : "  ";
    if (!section.name().empty())
      out << "\nsubsection " << section.name() << '\n';
    for (const Entry &entry : section.entries())
      if (!entry.text().empty())
        out << indent << "set " << padded(entry.name, longest_name(section)) << " = "
            << entry.text() << (entry.is_given() ? "" : " # default") << '\n';
    if (!section.name().empty())
      out << "end\n";
  }
}

void write_template(const std::vector<Section> &sections, std::ostream &out)
{
  write_comment("Parameters of an oblique impact. Every value carries its unit; everything after "
                "a # is a comment. An entry behind a # has a default, or stands for the one before "
                "it. Axes: x along "
                "the plate and the flight, y across, z up.",
                "", out);
  out << '\n';
  for (const Section &section : sections)
    write_template(section, out);
}
} // namespace ricochet
