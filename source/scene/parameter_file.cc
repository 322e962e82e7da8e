// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/parameter_file.h"

#include "error_list.h"
#include "file_reader.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/scene/text_tools.h"

namespace ricochet
{
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
  ErrorList errors;
  for (const auto &text : texts)
    errors.collect([&] { entries.push_back(parse_override(text)); });
  errors.throw_if_any();
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
  FileContent content = read_content(text, path);

  std::vector<ParameterEntry> seen;
  ErrorList errors;
  for (const auto &entry : overrides)
  {
    if (const ParameterEntry *const first = find_entry(seen, entry))
      errors.collect(
          [&]
          {
            throw InputError(entry.origin + ": " +
                             in_quotes(entry_path(entry.section, entry.name)) +
                             " is set twice, to " + in_quotes(first->value) + " (" + first->origin +
                             ") and to " + in_quotes(entry.value) + ".\n  Give one of the two.");
          });
    seen.push_back(entry);
    if (!entry.section.empty())
      add_section(content, {entry.section, entry.origin, false});
    override_with(content, entry);
  }
  errors.throw_if_any();

  ParameterFile file;
  file.path_     = path;
  file.entries_  = std::move(content.entries);
  file.sections_ = std::move(content.sections);
  return file;
}
} // namespace ricochet
