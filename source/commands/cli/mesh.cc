// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh.h"

#include "cli/command.h"
#include "cli/scene_options.h"

namespace ricochet
{
Command declare_mesh(CLI::App &app)
{
  const auto scene   = std::make_shared<SceneOptions>();
  const auto options = std::make_shared<MeshOptions>();
  auto *command      = app.add_subcommand(
           "mesh", "generate or read the projectile's mesh and print what it is worth");
  scene->declare(*command);
  command->add_option("--write", options->write, "gmsh file to write");
  return {command, [=](const MPI_Comm communicator)
          {
            mesh_projectile(communicator, scene->read(), *options);
            return 0;
          }};
}
} // namespace ricochet
