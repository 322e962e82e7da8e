// SPDX-License-Identifier: LGPL-2.1-or-later
// The section Study: rows, and what its texts mean. Cases are made of it in study_file.cc.
#pragma once

#include "ricochet/scene/study_file.h"
#include "section.h"

#include <string>
#include <vector>

namespace ricochet
{
/// A study may have the entries Axis 1 to Axis most_axes.
constexpr int most_axes = 20;

/// What the section says besides the study's own members, before there are cases.
struct StudySettings
{
  std::vector<std::string> scenes;       // as they are written
  std::vector<ParameterEntry> overrides; // that all cases share
  const Entry *scenes_row    = nullptr;  // that errors point at
  const Entry *directory_row = nullptr;
};

/// Bound to the study; a check fills its columns, axes and reference, and the settings. stem: name
/// of the parameter file, for the defaults.
Section study_section(const std::string &stem, StudyParameters &study, StudySettings &settings);

/// "base" of "scenes/base.prm", with all but letters, digits, points and signs as one underscore.
std::string scene_name(const std::string &scene);
} // namespace ricochet
