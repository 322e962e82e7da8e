// SPDX-License-Identifier: LGPL-2.1-or-later
// Somebody else's data, to be held against the history of a run: a CSV file with times and any
// columns of the history.
//
//   # X-ray pictures, by A. Uthor 2010            comments name the source
//   time [us],path [mm],path error [mm],kind      units in the header; error bars; words
//   94,48.1,1.5,published
//   142,72,,inferred                              an empty place: not known
#pragma once

#include "ricochet/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace ricochet
{
struct ReferenceData
{
  struct Column
  {
    std::string name, unit;                            // as in history.csv, whatever the file has
    std::vector<std::optional<double>> values, errors; // per time, in that unit; half a bar
  };
  std::string path;
  std::vector<std::string> source; // the comments, line by line
  std::vector<double> times;       // ascending [us]
  std::vector<std::string> kinds;  // per time what the column `kind` says, or ""
  std::vector<Column> columns;     // at least one
};

/// Length of the centroid's path since the start, which is no column of the history but may be one
/// of the data [mm].
constexpr const char *path_column = "path";

/**
 * Reads such a file. Columns are those of the history, and `path`; their units are converted.
 * `NAME error` is half the error bar of a column, `kind` and `note` are words.
 *
 * Throws FileError if it cannot be read, InputError with file, line and remedy for what it says.
 */
ReferenceData read_reference_data(const std::string &path);

/// The data that the scene names, if it does. Throws likewise.
std::optional<ReferenceData> reference_data_of(const Scene &scene);
} // namespace ricochet
