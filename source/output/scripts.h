// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the scripts that draw pictures lie, and running them.
#pragma once

#include "ricochet/output/job_pool.h" // this_program()

#include <filesystem>
#include <string>
#include <vector>

namespace ricochet
{
/**
 * The folder of the scripts for a program at this path: the one that the environment variable
 * RICOCHET_SCRIPT_DIR names; or else share/ricochet/scripts beside the program's folder, as it is
 * installed, or in it. No path is compiled in, so an installation may be moved; a build folder has
 * a link to the scripts of its source there. If there is none, the first of these places.
 */
std::filesystem::path script_folder(const std::filesystem::path &program);

/// The variables of this process without the marks of MPI, ended by a null pointer: what is started
/// with them is no part of this process's job.
std::vector<char *> environment_without_mpi();

struct ProgramResult
{
  int status;       // exit status, or -1 if the program could not be run
  std::string text; // what it printed, or why it could not be run
};

/// Runs a program, found as by a shell, with arguments and without a shell, and waits for it. Its
/// environment lacks the marks of an MPI process, which would make h5py start MPI in the script.
ProgramResult run_program(const std::string &program, const std::vector<std::string> &arguments);
} // namespace ricochet
