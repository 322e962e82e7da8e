// SPDX-License-Identifier: LGPL-2.1-or-later
// Which cases a study has, before their files are read, and reading one of them.
#pragma once

#include "ricochet/scene/study_file.h"

#include <string>
#include <vector>

namespace ricochet
{
/// A case before its file is read.
struct Plan
{
  std::string name, scene_file, scene;
  std::vector<ParameterEntry> overrides = {};
  std::vector<std::size_t> values       = {}; // of every axis in turn
};

/// "grid_spacing_1.5_mm"
std::string value_name(std::size_t axis, std::size_t value, const std::vector<StudyAxis> &axes);

/// The scene as it is.
Plan plan_of(const std::string &scene);

/// The plan with one more axis, at its value number v.
Plan with_value(Plan plan, const std::vector<StudyAxis> &axes, std::size_t a, std::size_t v);

/// All cases of a scene.
std::vector<Plan> plans_of(const std::string &scene, const StudyParameters &study);

/// Reads the case's file, with what all cases share, and all that it says. Throws InputError that
/// names the case.
StudyCase make_case(const StudyParameters &study, Plan plan);
} // namespace ricochet
