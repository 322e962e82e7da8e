// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/command.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/scene/parameter_template.h"

#include <iostream>
#include <memory>

namespace ricochet
{
Command declare_template(CLI::App &app)
{
  auto *command     = app.add_subcommand("template", "print a commented parameter file");
  const auto schema = std::make_shared<bool>(false);
  command->add_flag("--json", *schema, "all entries as one JSON object, for editors");
  return {command, [schema](const MPI_Comm communicator)
          {
            if (rank_in(communicator) == 0)
              (*schema ? print_schema : print_template)(std::cout);
            return 0;
          }};
}
} // namespace ricochet
