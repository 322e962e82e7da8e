// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/command.h"
#include "ricochet/scene/parameter_template.h"

#include <memory>

namespace ricochet
{
Command declare_template(CLI::App &app)
{
  auto *command     = app.add_subcommand("template", "print a commented parameter file");
  const auto schema = std::make_shared<bool>(false);
  command->add_flag("--json", *schema, "all entries as one JSON object, for editors");
  return {command, nullptr,
          [schema](std::ostream &out) { (*schema ? print_schema : print_template)(out); }};
}
} // namespace ricochet
