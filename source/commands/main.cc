// SPDX-License-Identifier: LGPL-2.1-or-later
// The command line. The one place that catches exceptions.
#include "cli/command.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/version.h"
#include "several_processes.h"
#include "start_watch.h"

#include <deal.II/base/mpi.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <xmmintrin.h>

namespace
{
using namespace ricochet;

int exit_status(const Error &error)
{
  return dynamic_cast<const InputError *>(&error)  ? 2
         : dynamic_cast<const FileError *>(&error) ? 3
                                                   : 4;
}

/// Without MPI, on the first of several processes.
int write_text(const Command &command)
{
  if (launched_rank().value_or(0) != 0)
    return 0;
  command.write(std::cout);
  if (std::cout.flush())
    return 0;
  std::cerr << "ricochet: The text cannot be written to the standard output.\n  Is the disk full?"
            << std::endl;
  return 3; // as for FileError
}

/// `complaint`: about the command line, if there is one.
int run_with_mpi(const CLI::App &app, const std::vector<Command> &commands,
                 const std::exception_ptr &complaint)
{
  // Debris and quiet regions drift into denormal numbers, on which the processor is a hundred times
  // slower.
  _mm_setcsr(_mm_getcsr() | 0x8040);
  // A file size limit should be a write error with a message, not a kill.
  std::signal(SIGXFSZ, SIG_IGN);

  try
  {
    if (complaint)
      std::rethrow_exception(complaint);
    return chosen(commands).execute(MPI_COMM_WORLD);
  }
  catch (const CLI::ParseError &error)
  {
    return explain(app, error, rank_in(MPI_COMM_WORLD) == 0);
  }
  catch (const Error &error)
  {
    if (rank_in(MPI_COMM_WORLD) == 0)
      std::cerr << "ricochet: " << error.what() << std::endl;
    return exit_status(error);
  }
  catch (const std::exception &error)
  {
    // Not one of ours, so perhaps on this rank alone: do not wait for the others.
    std::cerr << "ricochet: " << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 5);
  }
  return 5;
}
} // namespace

int main(int argc, char **argv)
{
  CLI::App app("ricochet: oblique impact and penetration with peridynamics");
  app.set_version_flag("--version", version());
  const auto commands = declare_commands(app);
  std::exception_ptr complaint;
  try
  {
    app.parse(argc, argv);
    const Command &command = chosen(commands);
    if (command.write)
      return write_text(command);
    if (const int status = start_processes(command.n_processes(), argc, argv))
      return status;
  }
  catch (const CLI::ParseError &error)
  {
    // --help and --version are such errors, too. When one of several processes ends with an error
    // mpirun ends the others, perhaps before the first has spoken; with MPI they end together.
    if (error.get_exit_code() == 0 || !launched_rank())
      return explain(app, error, launched_rank().value_or(0) == 0);
    complaint = std::current_exception();
  }
  std::optional<StartWatch> watch;
  if (!launched_rank())
    watch.emplace();
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  watch.reset();
  return run_with_mpi(app, commands, complaint);
}
