// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameter_writer.h"

#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <ostream>

namespace ricochet
{
std::string padded(std::string text, const std::size_t width)
{
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

void write_comment(const std::string &text, const std::string &indent, const std::size_t width,
                   std::ostream &out)
{
  std::string line = indent + "#";
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

void write_parameters(const std::vector<Section> &sections, std::ostream &out)
{
  for (const Section &section : sections)
  {
    const bool is_top = section.name().empty();
    if (!is_top)
      out << "\nsubsection " << section.name() << '\n';
    for (const Entry &entry : section.entries())
      if (!entry.text().empty())
        out << (is_top ? "set " : "  set ") << padded(entry.name, section.longest_name()) << " = "
            << entry.text() << (entry.is_given() ? "" : " # default") << '\n';
    if (!is_top)
      out << "end\n";
  }
}
} // namespace ricochet
