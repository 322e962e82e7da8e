// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for a limit as a study states it: between which outcomes, over what, how exactly.
#pragma once

#include "ricochet/scene/study_file.h"
#include "section.h"

#include <string>

namespace ricochet
{
/// "700 m/s": a number as the entries of cases have it.
std::string in_unit(double number, const std::string &unit);

struct LimitRows
{
  const Entry *limit, *range, *tolerance;
};
LimitRows add_limit(Section &in);

/// Adds the limit's axis to the study. Called after its axes and reference have been read. Throws
/// InputError.
void read_limit(const LimitRows &rows, StudyParameters &study);
} // namespace ricochet
