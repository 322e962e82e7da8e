// SPDX-License-Identifier: LGPL-2.1-or-later
// All sections that a kind of parameter file may have, in the order in which they are written.
#pragma once

#include "ricochet/scene/scene.h"
#include "ricochet/scene/stability_parameters.h"
#include "section.h"

#include <string>
#include <vector>

namespace ricochet
{
/// Sections by which the kinds of parameter files are told apart.
constexpr const char *study_name     = "Study";
constexpr const char *stability_name = "Stability";

/// "base" of "prm/base.prm".
std::string stem_of(const ParameterFile &file);

/**
 * The sections of a scene: as many plates and materials as it has. They are bound to the scene,
 * which must stay where it is as long as they are used, and keep its vectors as they are.
 *
 * @param stem   Name of the parameter file without folder and ending, for the defaults.
 * @param scene  Has all its plates, and its materials with their names.
 */
std::vector<Section> scene_sections(const std::string &stem, Scene &scene);

/// A scene with as many plates and materials as the file has, at least one; their names only.
/// Throws InputError if plates are not numbered 1, 2, 3 or the file does not describe a scene.
Scene empty_scene(const ParameterFile &file);

/// With these numbers and names.
Scene empty_scene(std::size_t n_plates, const std::vector<std::string> &materials);

/// The sections of a stability experiment, bound to it; stem as above.
std::vector<Section> stability_sections(const std::string &stem, StabilityParameters &experiment);
} // namespace ricochet
