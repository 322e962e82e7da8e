// SPDX-License-Identifier: LGPL-2.1-or-later
// A stability experiment from its parameter file to its results: used.prm and summary.json.
#pragma once

#include "run.h"

#include <vector>

namespace ricochet
{
/// Columns of the table of a study of such experiments.
extern const std::vector<std::string> stability_columns;

/// All that the summary of an experiment has.
std::vector<std::string> stability_fields();

/// Runs the experiment of a file with a section Stability into its results folder and returns its
/// summary. Collective; throws InputError and FileError like run_scene().
nlohmann::ordered_json run_stability(MPI_Comm communicator, const ParameterFile &file,
                                     const RunOptions &options);

/// One paragraph for the user.
std::string describe_stability(const nlohmann::ordered_json &summary);
} // namespace ricochet
