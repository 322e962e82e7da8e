// SPDX-License-Identifier: LGPL-2.1-or-later
// The results of a run explained: every column of the history, every field of the summary and of
// the frames.
#pragma once

#include <iosfwd>

namespace ricochet
{
/// Prints them with unit and meaning, as a table for the eye or as one JSON object, in which
/// "history", "summary" and "frames" are lists of objects with name, unit and meaning.
void print_columns(std::ostream &out, bool json);
} // namespace ricochet
