// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files as output: what a run used, and a commented file to start from.
#pragma once

#include "section.h"

#include <iosfwd>
#include <vector>

namespace ricochet
{
/// Every entry that has a value, in the order of declaration; values nobody set are marked.
void write_parameters(const std::vector<Section> &sections, std::ostream &out);

/// Every entry with its example value, below its documentation and what is expected. Entries that
/// stand for others (the second options of a Choice), that add something (no default, no Choice),
/// or whose default depends on the file's name, are commented out.
void write_template(const std::vector<Section> &sections, std::ostream &out);
} // namespace ricochet
