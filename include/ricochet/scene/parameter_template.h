// SPDX-License-Identifier: LGPL-2.1-or-later
// All entries that a parameter file may have: as a commented file to start from, and as a schema.
#pragma once

#include <iosfwd>

namespace ricochet
{
/**
 * Writes a scene that runs, with one comment per entry which ends in what is expected; what must be
 * given is marked '# required'. A study and a stability experiment follow behind '# ': without
 * these two characters each of them is a file of its own.
 */
void print_template(std::ostream &out);

/**
 * The same as one JSON object: "sections" with {file, name, meaning, repeats} and "entries" with
 *   file, section, name, meaning   where it stands ("scene", "study", "stability"; "" is the top)
 *   type         "quantity", "quantities" (a tuple), "quantity list", "choice", "flag" or "text"
 *   dimension, units, limit, components, values, expected    as far as the type has them
 *   default      as it is written, null without one; `<file>` stands for the name of the file
 *   example      a value that makes sense, with its unit
 *   required     whether a file without it is refused, whatever else it says
 *   rules        [{one_of: [[names], ...], if: {entry, values}}]: one group is to be given
 * A section that repeats (plates, materials) is listed once.
 */
void print_schema(std::ostream &out);
} // namespace ricochet
