// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/parameter_file.h"

#include "ricochet/base/exceptions.h"
#include "text_tools.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ricochet
{
namespace
{
namespace fs = std::filesystem;

/// What one file says itself and what it includes, kept apart because its own entries win.
struct Content
{
  std::vector<ParameterEntry> entries;
  std::vector<ParameterSection> sections;
};

ParameterEntry *find(std::vector<ParameterEntry> &entries, const ParameterEntry &wanted)
{
  for (auto &entry : entries)
    if (entry.section == wanted.section && entry.name == wanted.name)
      return &entry;
  return nullptr;
}

void override_with(Content &content, const ParameterEntry &entry)
{
  if (ParameterEntry *const present = find(content.entries, entry))
    *present = entry;
  else
    content.entries.push_back(entry);
}

void add_section(Content &content, const ParameterSection &section)
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

  Content read(const std::string &text)
  {
    std::istringstream lines(text.rfind("\xef\xbb\xbf", 0) == 0 ? text.substr(3) : text);
    std::string line;
    while (next_line(lines, line))
      read_line(line);
    if (!section_.empty())
      fail(section_line_, "The section " + in_quotes(section_) + " has no 'end'",
           "Add a line 'end' after its last entry.");

    Content content = std::move(included_);
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
    if (const ParameterEntry *const first = find(own_.entries, entry))
      fail(line_,
           in_quotes(entry_path(section_, entry.name)) + " is already set in " + first->origin,
           "Remove one of the two lines.");
    own_.entries.push_back(entry);
  }

  void open_section(const std::string &name)
  {
    if (name.empty())
      fail(line_, "The section has no name", "Write 'subsection NAME'.");
    if (!section_.empty())
      fail(line_,
           "The section " + in_quotes(name) + " begins inside the section " + in_quotes(section_) +
               ", which is open since line " + std::to_string(section_line_),
           "Sections do not contain sections; add the missing 'end' before this line.");
    section_      = name;
    section_line_ = line_;
    add_section(own_, {name, origin(line_), true});
  }

  void close_section(const std::string &rest)
  {
    if (!rest.empty())
      fail(line_, "Nothing may follow 'end', but " + in_quotes(rest) + " does",
           "Put a # before a comment.");
    if (section_.empty())
      fail(line_, "There is no section for this 'end' to close",
           "Remove it, or add the missing 'subsection NAME' line before it.");
    section_.clear();
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
    const Content content = reader.read(read_text(path, origin(line_)));
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
  Content own_, included_;
  std::string section_; // the open one, "" at the top
  unsigned int section_line_ = 0;
  unsigned int line_         = 0; // where the current line begins
  unsigned int last_line_    = 0; // and where it ends
};
} // namespace

ParameterEntry parse_override(const std::string &text, const std::string &origin)
{
  const auto equals      = text.find('=');
  const std::string path = squeezed(text.substr(0, equals));
  const auto slash       = path.rfind('/');
  ParameterEntry entry;
  entry.section = slash == std::string::npos ? "" : squeezed(path.substr(0, slash));
  entry.name    = squeezed(slash == std::string::npos ? path : path.substr(slash + 1));
  entry.value   = equals == std::string::npos ? "" : squeezed(text.substr(equals + 1));
  entry.origin  = origin;
  if (equals == std::string::npos || entry.name.empty())
    throw InputError(origin + ": " + in_quotes(text) +
                     " does not name an entry and its value.\n  Write \"Section/Entry=value\", for "
                     "example \"Impact/Speed=720 m/s\".");
  if (entry.value.find('#') != std::string::npos ||
      (!entry.value.empty() && entry.value.back() == '\\'))
    throw InputError(origin + ": The value in " + in_quotes(text) +
                     " contains # or ends in \\, which no parameter file can hold.\n  Choose a "
                     "value without them.");
  return entry;
}

std::vector<ParameterEntry> parse_overrides(const std::vector<std::string> &texts)
{
  std::vector<ParameterEntry> entries;
  for (const auto &text : texts)
    entries.push_back(parse_override(text));
  return entries;
}

ParameterFile::ParameterFile(const std::string &path,
                             const std::vector<ParameterEntry> &overrides) :
  ParameterFile(from_text(read_text(path, ""), path, overrides))
{
}

ParameterFile ParameterFile::from_text(const std::string &text, const std::string &path,
                                       const std::vector<ParameterEntry> &overrides)
{
  Content content = FileReader(path, {}).read(text);

  std::vector<ParameterEntry> seen;
  for (const auto &entry : overrides)
  {
    if (const ParameterEntry *const first = find(seen, entry))
      throw InputError(entry.origin + ": " + in_quotes(entry_path(entry.section, entry.name)) +
                       " is set twice, to " + in_quotes(first->value) + " (" + first->origin +
                       ") and to " + in_quotes(entry.value) + ".\n  Give one of the two.");
    seen.push_back(entry);
    if (!entry.section.empty())
      add_section(content, {entry.section, entry.origin, false});
    override_with(content, entry);
  }

  ParameterFile file;
  file.path_     = path;
  file.entries_  = std::move(content.entries);
  file.sections_ = std::move(content.sections);
  return file;
}
} // namespace ricochet
