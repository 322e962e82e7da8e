// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files as output.
#pragma once

#include "section.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace ricochet
{
/// Every entry that has a value, in the order of declaration; values nobody set are marked.
void write_parameters(const std::vector<Section> &sections, std::ostream &out);

/// The text as comment lines of at most `width` characters.
void write_comment(const std::string &text, const std::string &indent, std::size_t width,
                   std::ostream &out);

/// The text with blanks up to this width.
std::string padded(std::string text, std::size_t width);
} // namespace ricochet
