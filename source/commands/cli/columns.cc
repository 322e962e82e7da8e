// SPDX-License-Identifier: LGPL-2.1-or-later
#include "columns.h"

#include "cli/command.h"

namespace ricochet
{
Command declare_columns(CLI::App &app)
{
  const auto json = std::make_shared<bool>(false);
  auto *command   = app.add_subcommand(
        "columns",
        "print what stands in history.csv, summary.json and frames, with units and meaning");
  command->add_flag("--json", *json, "one JSON object");
  return {command, nullptr, [json](std::ostream &out) { print_columns(out, *json); }};
}
} // namespace ricochet
