// SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file with a section Stability to a checked experiment.
#pragma once

#include "ricochet/scene/parameter_file.h"
#include "ricochet/scene/stability_parameters.h"

namespace ricochet
{
/// Whether the file describes such an experiment, and not a scene.
bool is_stability_file(const ParameterFile &file);

/// Throws InputError like read_scene().
StabilityParameters read_stability(const ParameterFile &file);
} // namespace ricochet
