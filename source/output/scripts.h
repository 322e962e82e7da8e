// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the scripts that draw pictures lie, and running them.
#pragma once

#include "ricochet/output/job_pool.h" // this_program()

#include <chrono>
#include <filesystem>
#include <string>
#include <sys/types.h>
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

/// Starts a program, found as by a shell, with its arguments behind it, its output and errors going
/// into the pipe; 0, or the reason why not. `apart`: POSIX_SPAWN_SETPGROUP or _SETSID. posix_spawn
/// and not fork, because a fork of a process with MPI's registered memory is not safe.
int start_program(const std::vector<std::string> &words, int pipe_end, short apart, pid_t &process);

struct ProgramResult
{
  static constexpr int not_run = -1, not_ended = -2;

  int status;       // exit status; not_run if the program could not be; not_ended if it was killed
  std::string text; // what it printed, or why it could not be run or was stopped
};

/// Runs a program, found as by a shell, with arguments and without a shell, and waits for it. Its
/// environment lacks the marks of an MPI process, which would make h5py start MPI in the script.
/// After `limit` it is killed; pictures of the largest frames take a minute or two.
ProgramResult run_program(const std::string &program, const std::vector<std::string> &arguments,
                          std::chrono::seconds limit = std::chrono::minutes(10));
} // namespace ricochet
