// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/command.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/scene/scene_reader.h"

#include <iostream>

namespace ricochet
{
Command declare_template(CLI::App &app)
{
  auto *command = app.add_subcommand("template", "print a commented parameter file");
  return {command, [](const MPI_Comm communicator)
          {
            if (rank_in(communicator) == 0)
              print_template(std::cout);
            return 0;
          }};
}
} // namespace ricochet
