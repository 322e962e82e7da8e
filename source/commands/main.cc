// SPDX-License-Identifier: LGPL-2.1-or-later
// The command line. The one place that catches exceptions.
#include "bench.h"
#include "bench_elements.h"
#include "bench_history.h"
#include "bench_search.h"
#include "check.h"
#include "mesh.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/version.h"
#include "ricochet/output/collective.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "run.h"
#include "several_processes.h"
#include "stability_run.h"
#include "study.h"

#include <deal.II/base/mpi.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <iostream>
#include <sstream>
#include <xmmintrin.h>

namespace
{
using namespace ricochet;

struct Arguments
{
  std::string file, output;
  std::vector<std::string> settings;
  RunOptions run;
  CheckOptions check;
  StudyOptions study;
  KernelBenchOptions bench;
  ElementBenchOptions elements;
  HistoryBenchOptions history;
  SearchBenchOptions search;
  int n_processes = 1; // read by start_processes()
  MeshOptions mesh;
};

ParameterFile parameter_file(const Arguments &arguments)
{
  auto overrides = parse_overrides(arguments.settings);
  if (!arguments.output.empty())
    overrides.push_back({"Output", "Directory", arguments.output, "command line (--output)"});
  return ParameterFile(arguments.file, overrides);
}

void declare(CLI::App &app, Arguments &arguments)
{
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  const auto add_scene = [&](CLI::App *command)
  {
    command->add_option("file", arguments.file, "parameter file (.prm)")->required();
    command
        ->add_option("--set", arguments.settings,
                     "overrides one entry: --set \"Section/Entry=value\"; may be repeated")
        ->allow_extra_args(false);
  };

  auto *run = app.add_subcommand("run", "run a parameter file; also under mpirun -np N");
  add_scene(run);
  run->add_option("--output", arguments.output, "results folder instead of the one in the file");
  run->add_flag("--force", arguments.run.force, "overwrite the results in an existing folder");
  run->add_flag("--quiet", arguments.run.quiet, "print nothing but errors");

  auto *check =
      app.add_subcommand("check", "validate a parameter file and print what the run will cost");
  add_scene(check);
  check->add_flag("--coupling", arguments.check.coupling,
                  "test the interface between peridynamics and finite elements on this scene; exit "
                  "status 1 if a limit is not kept");

  auto *mesh = app.add_subcommand(
      "mesh", "generate or read the projectile's mesh and print what it is worth");
  add_scene(mesh);
  mesh->add_option("--write", arguments.mesh.write, "gmsh file to write");

  auto *study = app.add_subcommand("study", "run scenes over one or more axes and print one table");
  study->add_option("file", arguments.file, "study file (.prm with a section Study)")->required();
  study->add_flag("--resume", arguments.study.resume, "go on: skip the cases that are finished");
  study->add_flag("--quiet", arguments.study.quiet, "no progress of the single runs");

  auto *bench = app.add_subcommand("bench", "measure the speed of this machine, and rounding");
  bench->require_subcommand(1);
  auto *kernel = bench->add_subcommand("kernel", "the peridynamic lattice kernel, with damage");
  kernel->add_flag("--json", arguments.bench.json, "one JSON object");
  kernel->add_option("--edge", arguments.bench.points_per_edge, "points along an edge of the cube")
      ->capture_default_str();
  kernel->add_option("--repeats", arguments.bench.repeats, "timed repeats, the median counts")
      ->capture_default_str();
  kernel->add_option("--instruction-set", arguments.bench.instruction_set,
                     "avx512, avx2 or baseline; default: the best one");
  kernel->add_option("--bond-model", arguments.bench.bond_model, "bond law")->capture_default_str();
  kernel
      ->add_option("--viscous", arguments.bench.branches,
                   "relaxing branches, timed in turn with an elastic cube")
      ->capture_default_str();
  kernel->add_option("--history", arguments.bench.history, "single or double precision of those")
      ->capture_default_str();
  kernel->add_flag("--holes", arguments.bench.holes, "cut a sphere out of the cube");

  auto *elements = bench->add_subcommand("elements", "the explicit finite elements");
  elements->add_flag("--json", arguments.elements.json, "one JSON object");
  elements
      ->add_option("--edge", arguments.elements.elements_per_edge,
                   "elements along an edge of the cube")
      ->capture_default_str();
  elements->add_option("--repeats", arguments.elements.repeats, "timed repeats, the median counts")
      ->capture_default_str();
  elements
      ->add_option("--element", arguments.elements.element,
                   "one point, full, own tensors or general")
      ->capture_default_str();
  elements
      ->add_option("--viscous", arguments.elements.branches,
                   "relaxing branches, timed in turn with an elastic cube")
      ->capture_default_str();
  elements->add_option("--instruction-set", arguments.elements.instruction_set,
                       "avx512, avx2 or baseline; default: the best one");

  auto *history = bench->add_subcommand(
      "history", "the error of bonds with a history in single precision, one JSON object per row");
  history
      ->add_option("--decades", arguments.history.decades,
                   "time steps of 1 to 10^-decades relaxation times")
      ->capture_default_str();

  auto *search =
      bench->add_subcommand("search", "the contact searches, alone and on several processes");
  search->add_flag("--json", arguments.search.json, "one JSON object per row");
  search->add_option("--points", arguments.search.points, "numbers of points, comma-separated")
      ->delimiter(',')
      ->capture_default_str();
  search->add_option("--radius", arguments.search.radius, "search radius, as \"3 mm\"")
      ->capture_default_str();
  search->add_option("--edge", arguments.search.edge, "edge of the cube")->capture_default_str();
  search
      ->add_option("--arrangement", arguments.search.arrangements,
                   "random and lattice, or one of them")
      ->delimiter(',')
      ->capture_default_str();
  search->add_option("--repeats", arguments.search.repeats, "timed repeats, the median counts")
      ->capture_default_str();
  search
      ->add_option("--brute-force-up-to", arguments.search.most_for_brute_force,
                   "points above which brute force is left out")
      ->capture_default_str();
  search
      ->add_option("--processes", arguments.n_processes,
                   "measure on so many processes as well; they are started by mpirun")
      ->check(CLI::Range(1, most_processes));
  search->add_option("--plot", arguments.search.picture,
                     "draw seconds over points into this PNG; the rows go beside it, as .jsonl");

  app.add_subcommand("template", "print a commented parameter file");
}

int execute(const CLI::App &app, const Arguments &arguments)
{
  const MPI_Comm communicator = MPI_COMM_WORLD;
  if (app.got_subcommand("run"))
  {
    const auto file       = parameter_file(arguments);
    const bool experiment = is_stability_file(file);
    const auto summary    = (experiment ? run_stability : run)(communicator, file, arguments.run);
    if (!arguments.run.quiet && rank_in(communicator) == 0)
      std::cout << (experiment ? describe_stability : describe)(summary) << std::endl;
    return summary.value("interrupted", false) ? 130 : 0;
  }
  if (app.got_subcommand("check"))
    return check(communicator, parameter_file(arguments), arguments.check) ? 0 : 1;
  if (app.got_subcommand("mesh"))
    mesh(communicator, parameter_file(arguments), arguments.mesh);
  if (app.got_subcommand("study"))
    return study(communicator, arguments.file, arguments.study) == 0 ? 0 : 4;
  if (app.got_subcommand("bench"))
  {
    const CLI::App &bench = *app.get_subcommand("bench");
    if (bench.got_subcommand("kernel"))
      bench_kernel(communicator, arguments.bench);
    if (bench.got_subcommand("elements"))
      bench_elements(communicator, arguments.elements);
    if (bench.got_subcommand("history"))
      bench_history(communicator, arguments.history);
    if (bench.got_subcommand("search"))
      bench_search(communicator, arguments.search);
  }
  if (app.got_subcommand("template") && rank_in(communicator) == 0)
    print_template(std::cout);
  return 0;
}

int report(const std::exception &error, const int status)
{
  if (rank_in(MPI_COMM_WORLD) == 0)
    std::cerr << "ricochet: " << error.what() << std::endl;
  return status;
}
} // namespace

int main(int argc, char **argv)
{
  if (const int status = start_processes(argc, argv))
    return status;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // Debris and quiet regions drift into denormal numbers, on which the processor is a hundred times
  // slower.
  _mm_setcsr(_mm_getcsr() | 0x8040);
  // A file size limit should be a write error with a message, not a kill.
  std::signal(SIGXFSZ, SIG_IGN);

  CLI::App app("ricochet: oblique impact and penetration with peridynamics");
  Arguments arguments;
  declare(app, arguments);
  try
  {
    app.parse(argc, argv);
    return execute(app, arguments);
  }
  catch (const CLI::ParseError &error)
  {
    std::ostringstream nowhere;
    const bool speaks = rank_in(MPI_COMM_WORLD) == 0;
    const int status  = app.exit(error, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere);
    return status == 0 ? 0 : 2;
  }
  catch (const InputError &error)
  {
    return report(error, 2);
  }
  catch (const FileError &error)
  {
    return report(error, 3);
  }
  catch (const RunError &error)
  {
    return report(error, 4);
  }
  catch (const std::exception &error)
  {
    // Not one of ours, so perhaps on this rank alone: do not wait for the others.
    std::cerr << "ricochet: " << error.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 5);
  }
  return 5;
}
