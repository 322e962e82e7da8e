// SPDX-License-Identifier: LGPL-2.1-or-later
// What may be changed in a run that goes on: nothing that would have changed what is past.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <filesystem>

namespace ricochet
{
/// Entries that a resumed run may set, as "Section/Entry".
const std::vector<std::string> &entries_free_to_change();

/// The parameters of a run that goes on in `directory`: `text`, those it had, and overrides. Throws
/// InputError, naming them all, if some of these change an entry that is not free to change.
ParameterFile resumed_parameters(const std::string &text, const std::filesystem::path &directory,
                                 const std::vector<ParameterEntry> &overrides);
} // namespace ricochet
