// SPDX-License-Identifier: LGPL-2.1-or-later
// The options of all commands that read a scene.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ricochet
{
struct SceneOptions
{
  std::string file, output;          // output: results folder; "" for the one in the file
  std::vector<std::string> settings; // overrides

  /// Declares the file and --set, which write into this object.
  void declare(CLI::App &command);

  /// The file with its overrides. Throws InputError and FileError.
  ParameterFile read() const;
};
} // namespace ricochet
