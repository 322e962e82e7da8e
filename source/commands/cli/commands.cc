// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/command.h"

#include <algorithm>
#include <cassert>
#include <iostream>
#include <sstream>

namespace ricochet
{
std::vector<Command> declare_commands(CLI::App &app)
{
  app.require_subcommand(1);
  std::vector<Command> commands{declare_run(app), declare_check(app), declare_mesh(app),
                                declare_study(app)};
  for (const auto &bench : declare_benches(app))
    commands.push_back(bench);
  commands.push_back(declare_template(app));
  commands.push_back(declare_columns(app));
  return commands;
}

const Command &chosen(const std::vector<Command> &commands)
{
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [](const Command &command) { return command.app->parsed(); });
  assert(found != commands.end()); // one is required
  return *found;
}

int explain(const CLI::App &app, const CLI::ParseError &error, const bool speaks)
{
  std::ostringstream nowhere;
  const int status = app.exit(error, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere);
  return status == 0 ? 0 : 2; // as for InputError
}
} // namespace ricochet
