// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/elements.h"
#include "bench/history.h"
#include "bench/kernel.h"
#include "bench/search.h"
#include "cli/command.h"
#include "several_processes.h"

namespace ricochet
{
namespace
{
/// A command that hands its options to a bench.
template <class Options>
Command command_of(CLI::App *const app, const std::shared_ptr<Options> &options,
                   void (*const bench)(MPI_Comm, const Options &))
{
  return {app, [=](const MPI_Comm communicator)
          {
            bench(communicator, *options);
            return 0;
          }};
}

/// The options of the benches that time steps.
template <class Options>
void declare_timing(CLI::App &command, Options &options)
{
  command.add_flag("--json", options.json, "one JSON object");
  command.add_option("--repeats", options.repeats, "timed repeats, the median counts")
      ->capture_default_str();
  command.add_option("--instruction-set", options.instruction_set,
                     "avx512, avx2 or baseline; default: the best one");
  command
      .add_option("--viscous", options.branches,
                  "relaxing branches, timed in turn with an elastic cube")
      ->capture_default_str();
}

Command declare_kernel(CLI::App &bench)
{
  const auto options = std::make_shared<KernelBenchOptions>();
  auto *command = bench.add_subcommand("kernel", "the peridynamic lattice kernel, with damage");
  declare_timing(*command, *options);
  command->add_option("--edge", options->points_per_edge, "points along an edge of the cube")
      ->capture_default_str();
  command->add_option("--bond-model", options->bond_model, "bond law")->capture_default_str();
  command
      ->add_option("--history", options->history,
                   "single or double precision of the relaxing branches")
      ->capture_default_str();
  command->add_flag("--holes", options->holes, "cut a sphere out of the cube");
  return command_of(command, options, bench_kernel);
}

Command declare_elements(CLI::App &bench)
{
  const auto options = std::make_shared<ElementBenchOptions>();
  auto *command      = bench.add_subcommand("elements", "the explicit finite elements");
  declare_timing(*command, *options);
  command->add_option("--edge", options->elements_per_edge, "elements along an edge of the cube")
      ->capture_default_str();
  command->add_option("--element", options->element, "one point, full, own tensors or general")
      ->capture_default_str();
  return command_of(command, options, bench_elements);
}

Command declare_history(CLI::App &bench)
{
  const auto options = std::make_shared<HistoryBenchOptions>();
  auto *command      = bench.add_subcommand(
           "history", "the error of bonds with a history in single precision, one JSON object per row");
  command
      ->add_option("--decades", options->decades, "time steps of 1 to 10^-decades relaxation times")
      ->capture_default_str();
  return command_of(command, options, bench_history);
}

Command declare_search(CLI::App &bench)
{
  const auto options     = std::make_shared<SearchBenchOptions>();
  const auto n_processes = std::make_shared<int>(1);
  auto *command =
      bench.add_subcommand("search", "the contact searches, alone and on several processes");
  command->add_flag("--json", options->json, "one JSON object per row");
  command->add_option("--points", options->points, "numbers of points, comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--radius", options->radius, "search radius, as \"3 mm\"")
      ->capture_default_str();
  command->add_option("--edge", options->edge, "edge of the cube")->capture_default_str();
  command->add_option("--arrangement", options->arrangements, "random and lattice, or one of them")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--repeats", options->repeats, "timed repeats, the median counts")
      ->capture_default_str();
  command
      ->add_option("--brute-force-up-to", options->most_for_brute_force,
                   "points above which brute force is left out")
      ->capture_default_str();
  command
      ->add_option("--processes", *n_processes,
                   "measure on so many processes as well; they are started by mpirun")
      ->check(CLI::Range(1, most_processes));
  command->add_option("--plot", options->picture,
                      "draw seconds over points into this PNG; the rows go beside it, as .jsonl");
  Command search     = command_of(command, options, bench_search);
  search.n_processes = [n_processes] { return *n_processes; };
  return search;
}
} // namespace

std::vector<Command> declare_benches(CLI::App &app)
{
  auto *bench = app.add_subcommand("bench", "measure the speed of this machine, and rounding");
  bench->require_subcommand(1);
  return {declare_kernel(*bench), declare_elements(*bench), declare_history(*bench),
          declare_search(*bench)};
}
} // namespace ricochet
