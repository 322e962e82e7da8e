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
 * section or entry, a value that does not match its pattern, two options of one choice, and, in one
 * message, for all that is missing.
 */
void read_sections(const ParameterFile &file, std::vector<Section> &sections);

/// The same, with the checks.
void read_and_check_sections(const ParameterFile &file, std::vector<Section> &sections);
} // namespace ricochet
