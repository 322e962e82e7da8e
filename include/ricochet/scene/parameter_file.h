// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of a parameter file as a flat list of entries which know where they come from. The
// syntax is that of deal.II's ParameterHandler, one level of sections deep:
//
//   include base.prm           # relative to this file; this file's own entries win
//   set Title = A first shot
//   subsection Impact
//     set Speed = 720 m/s      # a line that ends in \ goes on in the next
//   end
//
// An empty value, "set Speed =", takes an included entry back.
#pragma once

#include <string>
#include <vector>

namespace ricochet
{
/// A value that a file or an override gives.
struct ParameterEntry
{
  std::string section; // "" at the top
  std::string name;    // "Grid spacing"
  std::string value;   // as written, blanks squeezed; "" means not given
  std::string origin;  // "prm/base.prm:12", "command line"
};

/// A section that a file or an override names.
struct ParameterSection
{
  std::string name;   // "Plate 1"
  std::string origin; // of the line that opens it first
  bool in_file;       // false: only an override names it
};

/**
 * Splits "Section/Entry=value", or "Entry=value" for an entry at the top, as given to --set.
 * Throws InputError if the text has another form.
 */
ParameterEntry parse_override(const std::string &text, const std::string &origin = "command line");
/// The same one by one.
std::vector<ParameterEntry> parse_overrides(const std::vector<std::string> &texts);

class ParameterFile
{
public:
  /// A file without entries.
  ParameterFile() = default;

  /**
   * Reads the file and all that it includes, then applies the overrides.
   * Throws FileError if a file cannot be read; InputError with file and line for a line that is
   * none of the forms above, for sections that are not closed, for an entry that one file (or the
   * overrides) sets twice, and for files that include each other.
   */
  explicit ParameterFile(const std::string &path,
                         const std::vector<ParameterEntry> &overrides = {});

  /// The same for a text; includes are relative to the folder of `path`, which need not exist.
  static ParameterFile from_text(const std::string &text, const std::string &path,
                                 const std::vector<ParameterEntry> &overrides = {});

  const std::string &path() const { return path_; }                       // as given
  const std::vector<ParameterEntry> &entries() const { return entries_; } // every entry once
  const std::vector<ParameterSection> &sections() const
  {
    return sections_;
  } // in order of first appearance

private:
  std::string path_;
  std::vector<ParameterEntry> entries_;    // every entry once
  std::vector<ParameterSection> sections_; // in order of first appearance, also empty ones
};
} // namespace ricochet
