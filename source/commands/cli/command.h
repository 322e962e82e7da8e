// SPDX-License-Identifier: LGPL-2.1-or-later
// The commands of the program: each declares its own options and says what it does with them.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <mpi.h>
#include <vector>

namespace ricochet
{
/// Has either `execute` or `write`, which are called with the options that have been parsed and
/// throw the exceptions of base/exceptions.h.
struct Command
{
  CLI::App *app; // its part of the command line
  /// Collective; returns the exit status.
  std::function<int(MPI_Comm)> execute      = nullptr;
  /// Of a command that does nothing but write a text, and does so also where MPI cannot start.
  std::function<void(std::ostream &)> write = nullptr;
  /// How many processes it asks for.
  std::function<int()> n_processes          = [] { return 1; };
};

Command declare_run(CLI::App &app);
Command declare_check(CLI::App &app);
Command declare_mesh(CLI::App &app);
Command declare_study(CLI::App &app);
std::vector<Command> declare_benches(CLI::App &app);
Command declare_template(CLI::App &app);
Command declare_columns(CLI::App &app);

/// All of them.
std::vector<Command> declare_commands(CLI::App &app);

/// The one that the parsed command line names.
const Command &chosen(const std::vector<Command> &commands);

/// Says, if this rank speaks, what was wrong with the command line, or what --help and --version
/// ask for; returns the exit status.
int explain(const CLI::App &app, const CLI::ParseError &error, bool speaks);
} // namespace ricochet
