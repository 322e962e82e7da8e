// SPDX-License-Identifier: LGPL-2.1-or-later
// One run from a parameter file to results on disk: builds the simulation, steps it to its end,
// writes history, frames, summary and pictures, and protects the user on the way.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <filesystem>
#include <mpi.h>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace ricochet
{
struct RunOptions
{
  bool force = false; // write into an existing results folder
  bool quiet = false; // no progress, no verdict
};

/**
 * Runs the scene of the file. Collective. Returns the summary, which also stands in summary.json.
 *
 * Throws InputError, FileError or RunError; a run that breaks down leaves its history, frames and a
 * summary which says so. SIGINT, SIGTERM and the wall-clock limit end the run in order after the
 * present step, with a checkpoint: "interrupted" is then true in the summary.
 */
nlohmann::ordered_json run_scene(MPI_Comm communicator, const ParameterFile &file,
                                 const RunOptions &options);

/**
 * Goes on with the run in `directory` from its newest checkpoint, on any number of ranks; all that
 * it writes becomes what it would have been without a break. `overrides`: see resumed_parameters().
 * Otherwise as run_scene(). Throws FileError if there is no checkpoint.
 */
nlohmann::ordered_json resume_scene(MPI_Comm communicator, const std::filesystem::path &directory,
                                    const std::vector<ParameterEntry> &overrides,
                                    const RunOptions &options);

/// The verdict of a summary in a few lines for the terminal.
std::string describe_run(const nlohmann::ordered_json &summary);
} // namespace ricochet
