// SPDX-License-Identifier: LGPL-2.1-or-later
// A study: several scenes, each run with every combination of values of a few entries.
//
//   subsection Study
//     set Scenes = base.prm, angle_10.prm
//     set Axis 1 = Plate 1/Grid spacing: 1.5 mm | 1.0 mm
//     set Axis 2 = Plate 1/Horizon ratio, Plate 2/Horizon ratio: 3 | 4    # changed together
//   end
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <string>
#include <vector>

namespace ricochet
{
struct StudyAxis
{
  std::vector<ParameterEntry> entries; // all take the same value; their own values are empty
  std::vector<std::string> values;
};

struct StudyCase
{
  std::string name;                      // "angle_10__grid_spacing_1.5_mm", also its folder
  std::string scene_file;                // for ParameterFile, together with
  std::vector<ParameterEntry> overrides; // the axes' values and the case's own output folder
};

struct StudyParameters
{
  std::string title;
  std::string output_directory;
  std::vector<std::string> columns; // empty: the driver's choice
  std::vector<std::string> scenes;  // paths of the parameter files
  std::vector<StudyAxis> axes;
  bool one_at_a_time; // the axes are varied one after the other instead of in all combinations
  bool pictures;      // draw a comparison at the end
  // Scene by scene, the last axis changes fastest; one at a time: the scene itself, then axis by
  // axis.
  std::vector<StudyCase> cases;
};

/**
 * Reads a study and every one of its cases, so that a mistake in the last one is found before the
 * first one runs. Throws InputError or FileError like ParameterFile and read_scene.
 */
StudyParameters read_study(const std::string &path);
} // namespace ricochet
