// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include "cli/command.h"
#include "cli/scene_options.h"

namespace ricochet
{
Command declare_check(CLI::App &app)
{
  const auto scene   = std::make_shared<SceneOptions>();
  const auto options = std::make_shared<CheckOptions>();
  auto *command =
      app.add_subcommand("check", "validate a parameter file and print what the run will cost");
  scene->declare(*command);
  command->add_flag(
      "--coupling", options->coupling,
      "test the interface between peridynamics and finite elements on this scene; exit "
      "status 1 if a limit is not kept");
  return {command, [=](const MPI_Comm communicator)
          { return check_scene(communicator, scene->read(), *options) ? 0 : 1; }};
}
} // namespace ricochet
