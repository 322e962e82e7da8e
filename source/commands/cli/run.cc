// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run.h"

#include "cli/command.h"
#include "cli/scene_options.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/scene/stability_reader.h"
#include "stability_run.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace ricochet
{
namespace
{
constexpr int ended_by_user = 130; // as a shell reports a program that Ctrl-C has ended

struct Options
{
  SceneOptions scene;
  RunOptions run;
};

int execute(const MPI_Comm communicator, const Options &options)
{
  const auto file       = options.scene.read();
  const bool experiment = is_stability_file(file);
  const auto summary    = (experiment ? run_stability : run_scene)(communicator, file, options.run);
  if (!options.run.quiet && rank_in(communicator) == 0)
    std::cout << (experiment ? describe_stability : describe_run)(summary) << std::endl;
  return summary.value("interrupted", false) ? ended_by_user : 0;
}
} // namespace

Command declare_run(CLI::App &app)
{
  const auto options = std::make_shared<Options>();
  auto *command      = app.add_subcommand("run", "run a parameter file; also under mpirun -np N");
  options->scene.declare(*command);
  command->add_option("--output", options->scene.output,
                      "results folder instead of the one in the file");
  command->add_flag("--force", options->run.force, "overwrite the results in an existing folder");
  command->add_flag("--quiet", options->run.quiet, "print nothing but errors");
  return {command,
          [options](const MPI_Comm communicator) { return execute(communicator, *options); }};
}
} // namespace ricochet
