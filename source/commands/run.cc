// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run.h"

#include "interruption.h"
#include "reference_comparison.h"
#include "result_folder.h"
#include "resume.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "ricochet/output/folder_lock.h"
#include "ricochet/output/pictures.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/plate_size.h"
#include "scene_run.h"

#include <cstdio>
#include <iostream>
#include <memory>

namespace ricochet
{
namespace
{
/// One line per plate whose extents the grid changes.
void tell_sizes(const Scene &scene)
{
  const auto sizes = plate_sizes(scene);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (!sizes[i].is_as_asked())
      std::printf("plate %zu is computed as %s instead of %s: a multiple of the grid spacing%s\n",
                  i + 1, size_text(sizes[i].computed).c_str(), size_text(sizes[i].asked).c_str(),
                  scene.zone.has_elements() ? " and of the largest elements" : "");
  std::fflush(stdout);
}

void draw_and_report(const MPI_Comm communicator, const Scene &scene, const RunOptions &options)
{
  if (scene.output.pictures)
    draw_pictures(communicator, scene.output.directory, options.quiet);
  if (scene.output.report)
    write_report(communicator, scene.output.directory, options.quiet);
}

std::unique_ptr<Simulation> build(const MPI_Comm communicator, const Scene &scene)
{
  const PhaseClock::Work work(Phase::set_up);
  return std::make_unique<Simulation>(communicator, scene);
}

/// From the beginning, or from a state that is there, in a folder that is locked then.
nlohmann::ordered_json run(const MPI_Comm communicator, const ParameterFile &file,
                           const RunOptions &options, ResumedState *const resumed,
                           std::unique_ptr<FolderLock> lock)
{
  outlive_closed_files();
  const auto time_before = time_spent(communicator);
  const Scene scene      = read_scene(file);
  auto data              = reference_data_of(scene); // before the work, not after it
  const auto built       = build(communicator, scene);
  Simulation &simulation = *built;
  if (resumed == nullptr)
  {
    prepare_result_folder(communicator, scene.output.directory, file, options.force);
    lock = std::make_unique<FolderLock>(communicator, scene.output.directory);
  }
  const bool speaks = !options.quiet && rank_in(communicator) == 0;
  if (speaks)
    tell_sizes(scene);
  // A run wants to begin: 3 % of the strain error are good enough. The test moves the nodes and
  // brings them back, so it comes before all that only looks at the simulation.
  auto interfaces = interface_reports(communicator, simulation, /*residual_left=*/3e-2);
  SceneRun run(communicator, simulation, std::move(interfaces), std::move(data), options,
               used_parameters(file));
  if (resumed != nullptr)
  {
    run.exchange_state(*resumed->archive);
    resumed->archive.reset();
    write_used_parameters_to(communicator, scene.output.directory, file);
    if (speaks)
      std::printf("resumed at %s us, step %ld, from %s\n",
                  with_decimals(simulation.time() / units::us, 2).c_str(), simulation.step(),
                  resumed->path.c_str());
  }
  try
  {
    auto summary = run(time_before);
    // Before the pictures: mpirun gives a run that it ends a second or so.
    if (speaks)
      std::cout << describe_run(summary) << std::endl;
    draw_and_report(communicator, scene, options);
    return summary;
  }
  catch (const RunError &)
  {
    draw_and_report(communicator, scene, options); // of what led to it
    throw;
  }
}

/// A run that was stopped before its first checkpoint.
nlohmann::ordered_json begin_anew(const MPI_Comm communicator,
                                  const std::filesystem::path &directory,
                                  const std::vector<ParameterEntry> &overrides,
                                  const RunOptions &options)
{
  const std::string text = parameters_of_unfinished_run(communicator, directory);
  if (!options.quiet && rank_in(communicator) == 0)
    std::printf("no checkpoint yet in %s: the run begins anew\n", directory.c_str());
  RunOptions anew = options;
  anew.force      = true;
  return run(communicator, resumed_parameters(text, directory, overrides), anew, nullptr, nullptr);
}
} // namespace

nlohmann::ordered_json run_scene(const MPI_Comm communicator, const ParameterFile &file,
                                 const RunOptions &options)
{
  return run(communicator, file, options, nullptr, nullptr);
}

nlohmann::ordered_json resume_scene(const MPI_Comm communicator,
                                    const std::filesystem::path &directory,
                                    const std::vector<ParameterEntry> &overrides,
                                    const RunOptions &options)
{
  auto lock = std::make_unique<FolderLock>(communicator, directory);
  if (!has_checkpoints(communicator, directory))
  {
    lock.reset(); // the folder is prepared anew
    return begin_anew(communicator, directory, overrides, options);
  }
  auto resumed    = newest_checkpoint(communicator, directory);
  const auto file = resumed_parameters(resumed.parameters, directory, overrides);
  return run(communicator, file, options, &resumed, std::move(lock));
}
} // namespace ricochet
