// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run.h"

#include "cli/command.h"
#include "cli/scene_options.h"
#include "ricochet/base/exceptions.h"
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
  std::string resumed; // folder of a run to go on with
};

/// A file or a folder, one of them.
void check(const Options &options)
{
  const bool resumes = !options.resumed.empty();
  if (!resumes && options.scene.file.empty())
    throw InputError("command line: what is to be run? Give a parameter file, or --resume with the "
                     "results folder of a run to go on with.");
  if (resumes &&
      (!options.scene.file.empty() || !options.scene.output.empty() || options.run.force))
    throw InputError("command line: --resume goes on in the folder '" + options.resumed +
                     "' with the parameters of the run there. Leave out the parameter file, "
                     "--output and --force; change entries with --set.");
}

nlohmann::ordered_json results(const MPI_Comm communicator, const Options &options)
{
  if (!options.resumed.empty())
    return resume_scene(communicator, options.resumed, parse_overrides(options.scene.settings),
                        options.run);
  return run_scene(communicator, options.scene.read(), options.run);
}

int execute(const MPI_Comm communicator, const Options &options)
{
  check(options);
  const bool experiment = options.resumed.empty() && is_stability_file(options.scene.read());
  const auto summary = experiment ? run_stability(communicator, options.scene.read(), options.run)
                                  : results(communicator, options);
  if (experiment && !options.run.quiet && rank_in(communicator) == 0)
    std::cout << describe_stability(summary) << std::endl;
  return summary.value("interrupted", false) ? ended_by_user : 0;
}
} // namespace

Command declare_run(CLI::App &app)
{
  const auto options = std::make_shared<Options>();
  auto *command      = app.add_subcommand("run", "run a parameter file; also under mpirun -np N");
  options->scene.declare(*command);
  command->get_option("file")->required(false);
  command->add_option("--resume", options->resumed,
                      "go on with the run in this results folder from its newest checkpoint, also "
                      "on another number of processes; --set may change times and intervals");
  command->add_option("--output", options->scene.output,
                      "results folder instead of the one in the file");
  command->add_flag("--force", options->run.force, "overwrite the results in an existing folder");
  command->add_flag("--quiet", options->run.quiet, "print nothing but errors");
  return {command,
          [options](const MPI_Comm communicator) { return execute(communicator, *options); }};
}
} // namespace ricochet
