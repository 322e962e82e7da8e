// SPDX-License-Identifier: LGPL-2.1-or-later
// Several programs at a time, whose lines do not mix and who end together.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ricochet
{
/// A program with its arguments, found as by a shell and run without one.
using Job = std::vector<std::string>;

/// The program that this process runs, to be run again.
std::filesystem::path this_program();

/// What becomes of the jobs, which are known by their numbers from 0.
struct JobListener
{
  std::function<void(std::size_t)> started; // just before it is
  /// A whole line of its output or of its errors, without the line's end.
  std::function<void(std::size_t, const std::string &)> line;
  /// Its exit status; minus the number of a signal; or, if it could not be started, -1000.
  std::function<void(std::size_t, int)> ended;
};
constexpr int not_started = -1000; // stands for the exit status of what could not be started

/**
 * Runs the jobs in their order, at most n_at_once at a time, and returns when all have ended. Their
 * environment lacks the marks of an MPI process, so that each may start MPI by itself.
 *
 * SIGINT and SIGTERM start no more jobs and are handed on as SIGINT to those that run, which are in
 * groups of their own, so that a terminal does not tell them too. Returns whether that happened.
 * Not collective: for one process alone.
 */
bool run_jobs(const std::vector<Job> &jobs, int n_at_once, const JobListener &listener);
} // namespace ricochet
