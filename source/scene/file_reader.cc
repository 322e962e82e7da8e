// SPDX-License-Identifier: LGPL-2.1-or-later
#include "file_reader.h"

#include "error_list.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace ricochet
{
namespace fs = std::filesystem;

ParameterEntry *find_entry(std::vector<ParameterEntry> &entries, const ParameterEntry &wanted)
{
  for (auto &entry : entries)
    if (entry.section == wanted.section && entry.name == wanted.name)
      return &entry;
  return nullptr;
}

void override_with(FileContent &content, const ParameterEntry &entry)
{
  if (ParameterEntry *const present = find_entry(content.entries, entry))
    *present = entry;
  else
    content.entries.push_back(entry);
}

void add_section(FileContent &content, const ParameterSection &section)
{
  for (const auto &present : content.sections)
    if (present.name == section.name)
      return;
  content.sections.push_back(section);
}

std::string read_text(const fs::path &path, const std::string &asked_by)
{
  const std::string where = asked_by.empty() ? "" : asked_by + ": ";
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw FileError(where + "There is no file " + in_quotes(path.string()) +
                    (asked_by.empty() ? "." : "; an include is relative to the including file."));
  if (fs::is_directory(path, ignored))
    throw FileError(where + in_quotes(path.string()) + " is a folder, not a parameter file.");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw FileError(where + "The file " + in_quotes(path.string()) +
                    " cannot be read; check its permissions.");
  return text.str();
}

namespace
{
/// Reads one file; included files are read by a reader of their own.
class FileReader
{
public:
  /// chain: the files being read, outermost first, as canonical paths.
  FileReader(fs::path path, std::vector<fs::path> chain) :
    path_(std::move(path)), chain_(std::move(chain))
  {
    std::error_code ignored;
    const fs::path canonical = fs::weakly_canonical(path_, ignored);
    chain_.push_back(canonical.empty() ? path_ : canonical);
  }

  FileContent read(const std::string &text)
  {
    std::istringstream lines(text.rfind("\xef\xbb\xbf", 0) == 0 ? text.substr(3) : text);
    std::string line;
    ErrorList errors;
    while (next_line(lines, line))
      errors.collect([&] { read_line(line); });
    if (!section_.empty() && errors.empty())
      fail(section_line_, "The section " + in_quotes(section_) + " has no 'end'",
           "Add a line 'end' after its last entry.");
    errors.throw_if_any();

    FileContent content = std::move(included_);
    for (const auto &section : own_.sections)
      add_section(content, section);
    for (const auto &entry : own_.entries)
      override_with(content, entry);
    return content;
  }

private:
  // One line without comment, joined with those it goes on in.
  bool next_line(std::istream &lines, std::string &line)
  {
    line.clear();
    line_ = last_line_ + 1;
    std::string part;
    while (std::getline(lines, part))
    {
      ++last_line_;
      part                 = part.substr(0, part.find('#'));
      const auto text_end  = part.find_last_not_of(" \t\r");
      const bool continues = text_end != std::string::npos && part[text_end] == '\\';
      line += continues ? part.substr(0, text_end) : part;
      if (!continues)
        break;
    }
    line = squeezed(line);
    return last_line_ >= line_;
  }

  void read_line(const std::string &line)
  {
    if (line.empty())
      return;
    const auto blank          = line.find(' ');
    const std::string keyword = lower_case(line.substr(0, blank));
    const std::string rest    = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (keyword == "set")
      read_entry(rest);
    else if (line.find('=') != std::string::npos)
      fail(line_, in_quotes(line) + " is not an entry",
           "An entry begins with 'set': 'set " + line + "'.");
    else if (keyword == "subsection")
      open_section(rest);
    else if (keyword == "end")
      close_section(rest);
    else if (keyword == "include")
      include(rest);
    else
      fail(line_,
           "The line " + in_quotes(line) + " cannot be understood" +
               guess(keyword, {"set", "subsection", "end", "include"}),
           "A line is 'set NAME = VALUE', 'subsection NAME', 'end', 'include FILE' or a comment "
           "that begins with #.");
  }

  void read_entry(const std::string &rest)
  {
    const auto equals = rest.find('=');
    if (equals == std::string::npos || squeezed(rest.substr(0, equals)).empty())
      fail(line_, in_quotes("set " + rest) + " does not have the form of an entry",
           "Write 'set NAME = VALUE'.");
    const ParameterEntry entry{section_, squeezed(rest.substr(0, equals)),
                               squeezed(rest.substr(equals + 1)), origin(line_)};
    if (const ParameterEntry *const first = find_entry(own_.entries, entry))
      fail(line_,
           in_quotes(entry_path(section_, entry.name)) + " is already set in " + first->origin,
           "Remove one of the two lines.");
    own_.entries.push_back(entry);
  }

  void open_section(const std::string &name)
  {
    const std::string before       = section_;
    const unsigned int line_before = section_line_;
    // The one that is open from here on, also if something is wrong: reading goes on.
    section_                       = name.empty() ? "?" : name;
    section_line_                  = line_;
    if (name.empty())
      fail(line_, "The section has no name", "Write 'subsection NAME'.");
    if (!before.empty())
      fail(line_,
           "The section " + in_quotes(name) + " begins inside the section " + in_quotes(before) +
               ", which is open since line " + std::to_string(line_before),
           "Sections do not contain sections; add the missing 'end' before this line.");
    add_section(own_, {name, origin(line_), true});
  }

  void close_section(const std::string &rest)
  {
    const bool was_open = !section_.empty();
    section_.clear();
    if (!rest.empty())
      fail(line_, "Nothing may follow 'end', but " + in_quotes(rest) + " does",
           "Put a # before a comment.");
    if (!was_open)
      fail(line_, "There is no section for this 'end' to close",
           "Remove it, or add the missing 'subsection NAME' line before it.");
  }

  void include(const std::string &name)
  {
    if (name.empty())
      fail(line_, "The include names no file", "Write 'include FILE'.");
    if (!section_.empty())
      fail(line_, "The include stands inside the section " + in_quotes(section_),
           "Move it to the top of the file.");
    const fs::path path = (path_.parent_path() / name).lexically_normal();
    FileReader reader(path, chain_);
    check_cycle(reader.chain_);
    const FileContent content = reader.read(read_text(path, origin(line_)));
    for (const auto &section : content.sections)
      add_section(included_, section);
    for (const auto &entry : content.entries)
      override_with(included_, entry);
  }

  void check_cycle(const std::vector<fs::path> &chain) const
  {
    const auto first = std::find(chain.begin(), chain.end() - 1, chain.back());
    if (first == chain.end() - 1)
      return;
    std::string circle;
    for (auto file = first; file != chain.end(); ++file)
      circle += (file == first ? "" : " -> ") + file->filename().string();
    fail(line_, "The files include each other in a circle: " + circle,
         "Remove one of the include lines.");
  }

  std::string origin(const unsigned int line) const
  {
    return path_.string() + ":" + std::to_string(line);
  }

  [[noreturn]] void fail(const unsigned int line, const std::string &what,
                         const std::string &remedy) const
  {
    const char last = what.back();
    throw InputError(origin(line) + ": " + what + (last == '?' || last == '.' ? "" : ".") + "\n  " +
                     remedy);
  }

  fs::path path_;
  std::vector<fs::path> chain_;
  FileContent own_, included_;
  std::string section_; // the open one, "" at the top
  unsigned int section_line_ = 0;
  unsigned int line_         = 0; // where the current line begins
  unsigned int last_line_    = 0; // and where it ends
};
} // namespace

FileContent read_content(const std::string &text, const fs::path &path)
{
  return FileReader(path, {}).read(text);
}
} // namespace ricochet
