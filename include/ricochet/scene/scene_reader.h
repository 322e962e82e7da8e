// SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to a checked scene, and back: the parameters that were used.
#pragma once

#include "ricochet/scene/parameter_file.h"
#include "ricochet/scene/scene.h"

#include <iosfwd>
#include <string>

namespace ricochet
{
/**
 * The scene a parameter file describes, in SI, with all defaults filled in.
 *
 * Throws InputError, in one message with file and line, for whatever is unknown, missing, of the
 * wrong form or contradictory; the checks stand with the entries, in the sections' files.
 */
Scene read_scene(const ParameterFile &file);

/// The text of one entry of a scene (or experiment) that read_scene accepts, or its default; "" if
/// there is none.
std::string used_value(const ParameterFile &file, const std::string &section,
                       const std::string &name);

/**
 * Writes all parameters of a scene (or experiment) that read_scene accepts, defaults included and
 * marked, units kept, in the order of their declaration. Read again, the text gives the same scene.
 */
void write_used_parameters(const ParameterFile &file, std::ostream &out);
} // namespace ricochet
