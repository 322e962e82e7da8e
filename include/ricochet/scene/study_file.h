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
#include <optional>
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

/// A column of the study's table that says what is varied.
struct StudyColumn
{
  std::string name;  // "grid_spacing_mm"
  std::string label; // "grid spacing", to be read
  std::string unit;  // "mm", "" for plain numbers and words
  bool is_number;    // otherwise its values are words
};

/// What stands in such a column.
struct AxisValue
{
  std::string text;             // as in the parameter file
  std::optional<double> number; // in the unit of the column
};

/// How cases are made of the axes' values.
enum class Combination
{
  all,           // every value of one axis with every value of the others
  one_at_a_time, // the axes are varied one after the other
  zipped         // the first values of all axes, then the second ones
};

/// What a study is for, beyond its table.
enum class StudyKind
{
  cases,      // its runs
  map,        // outcomes over two axes of numbers
  convergence // what becomes of the results when the first axis is refined
};

/// A limit that is searched for by bisection over the values of an entry.
struct StudyLimit
{
  std::size_t axis;   // of the study, its last; has both ends of the range as its first values
  std::size_t column; // of the study's axis_columns
  double low;         // lower end of the range, in the unit of that column
  double high;        // upper end
  double tolerance;   // of the bracket's width, in that unit
  std::string below;  // outcome at the low end; "other": all but the one at the other end
  std::string above;  // at the high end, likewise
};

/// One run.
struct StudyCase
{
  std::string name;                // "angle_10__grid_spacing_1.5_mm", also its folder
  std::string scene;               // "angle_10"
  std::vector<std::size_t> values; // of every axis in turn, the number of its value
  ParameterFile file; // the scene with the axes' values and the case's own output folder
  bool is_experiment; // of stability, for read_stability instead of read_scene
  std::string label;  // to be read: "angle 10, 1.5 mm"
  std::vector<AxisValue> axis_values; // one for each of the study's axis_columns
};

/// All runs.
struct StudyParameters
{
  std::string title;                     // of the results
  std::string output_directory;          // of the study; cases have folders in it
  std::string path;                      // of the study's file, as given
  std::vector<std::string> columns;      // empty: the driver's choice
  std::string columns_origin;            // of that entry: "study.prm:4"
  std::vector<std::string> scenes;       // paths of the parameter files
  std::vector<StudyAxis> axes;           // at most 20
  std::vector<StudyColumn> axis_columns; // one per axis, or per entry with values of its own
  Combination combination;               // how the axes' values make cases
  StudyKind kind;                        // what it is for
  std::optional<StudyLimit> limit;       // to be searched for
  std::size_t finest;                    // of a study of convergence: value of the first axis that
                                         // the others are compared with
  std::vector<ParameterEntry> shared;    // entries that all cases share
  std::string directory_origin;          // of the output directory
  bool pictures;                         // draw a comparison at the end
  bool report;                           // write report.html at the end
  std::string reference; // the scene that the others are compared with, as in StudyCase; or ""
  /// Scene by scene, the last axis changes fastest; one at a time: the scene itself, then axis by
  /// axis. With a reference the scenes change fastest: what is compared runs one after the other,
  /// and a machine whose speed drifts is as unfair to one as to the other.
  std::vector<StudyCase> cases;
};

/// Adds a case like the one of that number with another value of the limit's entry, in the unit of
/// its column. Throws as read_study().
void add_limit_case(StudyParameters &study, std::size_t like, double value);

/// "grid_spacing_1.5_mm__size_198_mm" of a case of the study: the values of its axes without those
/// of the ensemble, "" if there are none. One at a time is not supported.
std::string group_name(const StudyParameters &study, const StudyCase &one);

/// The same to be read: "1.5 mm, 198 mm"; plain numbers carry the name of their entry.
std::string group_title(const StudyParameters &study, const StudyCase &one);

/// Throws InputError, with a guess, if a column that the study asks for is none of these.
void check_columns(const StudyParameters &study, const std::vector<std::string> &known);

/// Whether the file describes a study, and not a scene.
bool is_study_file(const ParameterFile &file);

/**
 * Reads a study and every one of its cases, so that a mistake in the last one is found before the
 * first one runs. Throws InputError or FileError like ParameterFile and read_scene.
 */
StudyParameters read_study(const std::string &path);
} // namespace ricochet
