// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/scene_options.h"

namespace ricochet
{
void SceneOptions::declare(CLI::App &command)
{
  command.add_option("file", file, "parameter file (.prm)")->required();
  command
      .add_option("--set", settings,
                  "overrides one entry: --set \"Section/Entry=value\"; may be repeated")
      ->allow_extra_args(false);
}

ParameterFile SceneOptions::read() const
{
  auto overrides = parse_overrides(settings);
  if (!output.empty())
    overrides.push_back({"Output", "Directory", output, "command line (--output)"});
  return ParameterFile(file, overrides);
}
} // namespace ricochet
