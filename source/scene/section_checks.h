// SPDX-License-Identifier: LGPL-2.1-or-later
// A parameter file held against the sections it may have: every name known, every value of the
// declared form, nothing missing.
#pragma once

#include "section.h"

#include <string>
#include <vector>

namespace ricochet
{
/**
 * Reads the file into the sections and gives the bound variables their values; checks between
 * entries (Section::check) are not run.
 *
 * Throws InputError that names file, line, value, what is expected and what to do: for an unknown
 * section or entry, a value that does not match its pattern, two options of one choice, and for all
 * that is missing. One message has all errors of these kinds; what may follow from a misspelt name
 * is left out.
 */
void read_sections(const ParameterFile &file, std::vector<Section> &sections);

/// The same, with the checks: those of each section, and if all hold, those with other sections.
/// Each of the two kinds is told in one message, too.
void read_and_check_sections(const ParameterFile &file, std::vector<Section> &sections);
} // namespace ricochet
