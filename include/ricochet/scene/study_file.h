// SPDX-License-Identifier: LGPL-2.1-or-later
// A study: several scenes, each run with every combination of values of a few entries.
//
//   subsection Study
//     set Scenes = base.prm, angle_10.prm
//     set Axis 1 = Plate 1/Grid spacing: 1.5 mm | 1.0 mm
//     set Axis 2 = Plate 1/Horizon ratio, Plate 2/Horizon ratio: 3 | 4    # changed together
//     set Axis 3 = Impact/Speed, Impact/Attack angle: 720 m/s; 0 deg | 800 m/s; 2 deg
//   end
//
// With a reference, every scene is compared with that one under the same values of the axes; the
// axes of the ensemble only repeat a run.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ricochet
{
/// What is varied together.
struct StudyAxis
{
  std::vector<ParameterEntry> entries; // their own values are empty
  /// One for all entries, or one for each with ';' between them.
  std::vector<std::string> values;
  bool is_ensemble = false; // whether it only repeats a run
};

/// One run.
struct StudyCase
{
  std::string name;                // "angle_10__grid_spacing_1.5_mm", also its folder
  std::string scene;               // "angle_10"
  std::vector<std::size_t> values; // of every axis in turn, the number of its value
  ParameterFile file; // the scene with the axes' values and the case's own output folder
  bool is_experiment; // of stability, for read_stability instead of read_scene
};

/// All runs.
struct StudyParameters
{
  std::string title;                // of the results
  std::string output_directory;     // of the study; cases have folders in it
  std::vector<std::string> columns; // empty: the driver's choice
  std::vector<std::string> scenes;  // paths of the parameter files
  std::vector<StudyAxis> axes;      // at most 20
  bool one_at_a_time;    // the axes are varied one after the other instead of in all combinations
  bool pictures;         // draw a comparison at the end
  std::string reference; // the scene that the others are compared with, as in StudyCase; or ""
  /// Scene by scene, the last axis changes fastest; one at a time: the scene itself, then axis by
  /// axis. With a reference the scenes change fastest: what is compared runs one after the other,
  /// and a machine whose speed drifts is as unfair to one as to the other.
  std::vector<StudyCase> cases;
};

/// "grid_spacing_1.5_mm__size_198_mm" of a case of the study: the values of its axes without those
/// of the ensemble, "" if there are none. One at a time is not supported.
std::string group_name(const StudyParameters &study, const StudyCase &one);

/// The same to be read: "1.5 mm, 198 mm"; plain numbers carry the name of their entry.
std::string group_title(const StudyParameters &study, const StudyCase &one);

/// Whether the file describes a study, and not a scene.
bool is_study_file(const ParameterFile &file);

/**
 * Reads a study and every one of its cases, so that a mistake in the last one is found before the
 * first one runs. Throws InputError or FileError like ParameterFile and read_scene.
 */
StudyParameters read_study(const std::string &path);
} // namespace ricochet
