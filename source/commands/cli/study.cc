// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "cli/command.h"

namespace ricochet
{
namespace
{
constexpr int some_failed   = 4;    // as for a run that breaks down
constexpr int most_jobs     = 1024; // more is a slip
constexpr int ended_by_user = 130;  // as a shell reports a program that Ctrl-C has ended

struct Options
{
  std::string file;
  StudyOptions study;
};
} // namespace

Command declare_study(CLI::App &app)
{
  const auto options = std::make_shared<Options>();
  auto *command =
      app.add_subcommand("study", "run scenes over one or more axes and print one table");
  command->add_option("file", options->file, "study file (.prm with a section Study)")->required();
  command->add_flag("--resume", options->study.resume, "go on: skip the cases that are finished");
  auto *list = command->add_flag("--list", options->study.list,
                                 "number the cases and say which are finished; runs nothing");
  auto *only = command->add_option("--case", options->study.only,
                                   "run only the case of this number or name, for job arrays");
  auto *dry  = command
                  ->add_flag("--dry-run", options->study.dry_run,
                             "what every case will cost, by steps, core-seconds and memory; runs "
                             "nothing")
                  ->excludes(list)
                  ->excludes(only);
  command
      ->add_flag("--collect", options->study.collect,
                 "table, pictures and report of what is finished; runs nothing")
      ->excludes(list)
      ->excludes(only)
      ->excludes(dry);
  command
      ->add_option("--jobs", options->study.n_jobs,
                   "so many cases at a time, each in a process of its own")
      ->check(CLI::Range(1, most_jobs));
  command->add_flag("--quiet", options->study.quiet, "no progress of the single runs");
  return {command, [options](const MPI_Comm communicator)
          {
            const auto end = run_study(communicator, options->file, options->study);
            return end.interrupted ? ended_by_user : end.n_failed > 0 ? some_failed : 0;
          }};
}
} // namespace ricochet
