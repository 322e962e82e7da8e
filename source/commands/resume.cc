// SPDX-License-Identifier: LGPL-2.1-or-later
#include "resume.h"

#include "result_folder.h"
#include "ricochet/base/exceptions.h"

#include <algorithm>

namespace ricochet
{
namespace
{
std::string name_of(const ParameterEntry &entry)
{
  return entry.section.empty() ? entry.name : entry.section + '/' + entry.name;
}

/// What `after` has that `before` has not, or not so.
std::vector<ParameterEntry> changed(const ParameterFile &before, const ParameterFile &after)
{
  std::vector<ParameterEntry> entries;
  for (const auto &entry : after.entries())
    if (std::none_of(before.entries().begin(), before.entries().end(),
                     [&](const ParameterEntry &other)
                     { return name_of(other) == name_of(entry) && other.value == entry.value; }))
      entries.push_back(entry);
  return entries;
}
} // namespace

const std::vector<std::string> &entries_free_to_change()
{
  static const std::vector<std::string> entries{"Time/Final time",
                                                "Time/Stop early",
                                                "Time/Wall-clock limit",
                                                "Output/Directory",
                                                "Output/Frame interval",
                                                "Output/History interval",
                                                "Output/Checkpoint interval",
                                                "Output/Checkpoint wall-clock interval",
                                                "Output/Pictures",
                                                "Output/Report",
                                                "Output/Reference data"};
  return entries;
}

ParameterFile resumed_parameters(const std::string &text, const std::filesystem::path &directory,
                                 const std::vector<ParameterEntry> &overrides)
{
  const std::string path = (directory / "used.prm").string();
  auto all               = overrides;
  all.push_back({"Output", "Directory", directory.string(), "command line (--resume)"});
  const auto before = ParameterFile::from_text(text, path);
  auto after        = ParameterFile::from_text(text, path, all);
  // Compared as they are used: with defaults, whoever has written them out.
  std::string refused;
  const auto &free = entries_free_to_change();
  for (const auto &entry : changed(ParameterFile::from_text(used_parameters(before), path),
                                   ParameterFile::from_text(used_parameters(after), path)))
    if (std::find(free.begin(), free.end(), name_of(entry)) == free.end())
      refused += (refused.empty() ? "'" : ", '") + name_of(entry) + "'";
  if (refused.empty())
    return after;
  std::string allowed;
  for (const auto &name : free)
    allowed += (allowed.empty() ? "" : ", ") + name;
  throw InputError("command line: " + refused +
                   " cannot change in a run that goes on: it would have begun differently. Start "
                   "it anew, or change only these: " +
                   allowed + ".");
}
} // namespace ricochet
