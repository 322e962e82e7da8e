// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of parameter files, line by line, with what they include.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ricochet
{
/// What one file says itself and what it includes, kept apart because its own entries win.
struct FileContent
{
  std::vector<ParameterEntry> entries;
  std::vector<ParameterSection> sections;
};

/// The entry of the same section and name, or nullptr.
ParameterEntry *find_entry(std::vector<ParameterEntry> &entries, const ParameterEntry &wanted);

/// Replaces the entry of the same section and name, or adds it.
void override_with(FileContent &content, const ParameterEntry &entry);

/// Adds it unless there is one of this name.
void add_section(FileContent &content, const ParameterSection &section);

/// Throws FileError that begins with `asked_by`, the line of an include, or "".
std::string read_text(const std::filesystem::path &path, const std::string &asked_by);

/// Everything that a text says; path: of the file that it stands in. Throws like ParameterFile.
FileContent read_content(const std::string &text, const std::filesystem::path &path);
} // namespace ricochet
