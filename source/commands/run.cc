// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run.h"

#include "command_line.h"
#include "interruption.h"
#include "reference_comparison.h"
#include "result_folder.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/base/version.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/field_writer.h"
#include "ricochet/output/history.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/progress.h"
#include "ricochet/output/summary.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/observation.h"
#include "ricochet/simulation/plate_size.h"
#include "ricochet/simulation/run_summary.h"
#include "ricochet/simulation/sanity_check.h"
#include "run_warnings.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

namespace ricochet
{
namespace
{
/// Processor time of all ranks so far: what a run costs, also where others use the machine. [s]
/// Collective.
double cpu_seconds(const MPI_Comm communicator)
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  double sum         = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return sum;
}

std::vector<History::Column> names_and_units()
{
  std::vector<History::Column> columns;
  for (const auto &column : history_columns())
    columns.push_back({column.name, column.unit});
  return columns;
}

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

/// Something that is due every so often in simulated time.
class Schedule
{
public:
  explicit Schedule(const double interval) : interval_(interval) {} // [s]; 0: never

  bool is_due(const double time) const { return interval_ > 0. && time >= next_; }
  void done(const double time)
  {
    while (interval_ > 0. && next_ <= time)
      next_ += interval_;
  }

private:
  double interval_, next_ = 0.; // [s]
};

class Run
{
public:
  /// Of a simulation at its start, which must outlive this object. `directory` is prepared.
  Run(const MPI_Comm communicator, Simulation &simulation, std::vector<InterfaceReport> interfaces,
      std::optional<ReferenceData> data, const RunOptions &options) :
    communicator_(communicator),
    options_(options), simulation_(simulation), scene_(simulation.scene()),
    watch_(watch_of(simulation)), damage_(communicator, simulation), warnings_(communicator),
    directory_(scene_.output.directory), history_(communicator, directory_, names_and_units()),
    frames_(communicator, directory_, scene_.output.vtu),
    records_due_(scene_.output.history_interval), frames_due_(scene_.output.frame_interval),
    data_(std::move(data))
  {
    notes_.directory     = directory_.string();
    notes_.version       = version();
    notes_.command       = command_line();
    notes_.n_ranks       = size_of(communicator);
    notes_.n_points      = simulation.n_points();
    notes_.n_bonds       = damage_.n_bonds();
    notes_.start_momenta = simulation.momenta();
    notes_.interfaces    = std::move(interfaces);
  }

  /// To the end; `start_cpu_seconds` when all of it began.
  nlohmann::ordered_json operator()(const double start_cpu_seconds)
  {
    Progress progress(communicator_, scene_.time.end_time, options_.quiet);
    try
    {
      loop(progress);
    }
    catch (const RunError &error)
    {
      // What there is stays usable: close the history and say what happened.
      progress.finish();
      notes_.failed = true;
      finish({Outcome::undecided, ExitFace::none, 0, error.what()}, start_cpu_seconds);
      throw;
    }
    progress.finish();
    return finish(verdict_, start_cpu_seconds);
  }

private:
  void loop(Progress &progress)
  {
    Interruption interruption;
    for (bool last = false;;)
    {
      const double time      = simulation_.time();
      const bool record_due  = last || records_due_.is_due(time);
      const bool picture_due = is_picture_due();
      const bool frame_due =
          picture_due || frames_due_.is_due(time) || (last && scene_.output.frame_interval > 0.);
      simulation_.compute_forces(record_due);
      watch_.update(observe(simulation_));
      warnings_.update(simulation_);
      if (record_due)
        record();
      if (frame_due)
        write_frame();
      if (picture_due)
        notes_.positions.push_back(
            sighting(simulation_, watch_, scene_.output.picture_times[notes_.positions.size()]));
      show(progress);
      if (last)
      {
        // A decision that ended the run stands, whatever the last step has brought.
        if (!decided_)
          verdict_ = watch_.verdict(stop_reason_);
        return;
      }

      simulation_.advance();
      last = must_stop(interruption);
    }
  }

  /// Whether the next step is the last one; notes why.
  bool must_stop(const Interruption &interruption)
  {
    if (interruption.requested(communicator_))
    {
      notes_.interrupted = true;
      stop_reason_       = "interrupted";
    }
    else if (simulation_.time() >= scene_.time.end_time)
      stop_reason_ = "the final time was reached";
    decided_ = scene_.time.stop_early && watch_.decided();
    if (decided_)
      verdict_ = watch_.verdict(stop_reason_);
    return decided_ || !stop_reason_.empty();
  }

  void record()
  {
    records_due_.done(simulation_.time());
    simulation_.check_finite();
    totals_ = totals_of(simulation_);
    const Moment moment{simulation_, totals_};
    history_.append(history_record(moment));
    warnings_.update(moment);
    check_energy(moment);
  }

  bool is_picture_due() const
  {
    const auto &times = scene_.output.picture_times;
    return notes_.positions.size() < times.size() &&
           simulation_.time() >= times[notes_.positions.size()];
  }

  void write_frame()
  {
    frames_due_.done(simulation_.time());
    const auto extent = frames_.extent();
    frames_.write(simulation_.time(), simulation_.points(extent), simulation_.surface(),
                  simulation_.elements(extent));
  }

  /// Directed bonds evaluated per second of wall time, all ranks [1/s].
  double bond_rate() const
  {
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return 2. * simulation_.computed_share() * notes_.n_bonds * simulation_.step() /
           std::max(elapsed, 1e-9);
  }

  void show(Progress &progress) const
  {
    progress.update({simulation_.time(), simulation_.step(),
                     simulation_.projectile().motion().velocity.norm(),
                     simulation_.projectile().pitch() / units::deg, totals_.broken_bonds,
                     totals_.relative_residual(), bond_rate()});
  }

  nlohmann::ordered_json finish(const OutcomeVerdict &verdict, const double start_cpu_seconds)
  {
    notes_.core_seconds      = cpu_seconds(communicator_) - start_cpu_seconds;
    notes_.bond_rate         = bond_rate();
    notes_.deepest           = warnings_.deepest();
    notes_.on_elements_since = warnings_.on_elements_since();
    notes_.hourglass         = warnings_.hourglass();
    notes_.warnings          = warnings_.given();
    if (data_)
      on_first_rank(communicator_,
                    [&] { notes_.reference_data = compare_with_data(directory_, *data_); });
    auto summary = run_summary({simulation_, watch_, verdict, totals_, notes_}, damage_.plates());
    write_summary(communicator_, directory_, summary);
    write_damage_maps(communicator_, directory_, damage_.maps());
    history_.close();
    return summary;
  }

  MPI_Comm communicator_;
  RunOptions options_;
  Simulation &simulation_;
  const Scene &scene_;
  OutcomeWatch watch_;
  DamageReport damage_;
  RunWarnings warnings_;
  std::filesystem::path directory_;
  History history_;
  FieldWriter frames_;
  Schedule records_due_, frames_due_;
  Totals totals_; // of the last record
  std::optional<ReferenceData> data_;
  RunNotes notes_;
  std::string stop_reason_;
  bool decided_ = false; // and therefore at an end
  OutcomeVerdict verdict_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};
} // namespace

nlohmann::ordered_json run_scene(const MPI_Comm communicator, const ParameterFile &file,
                                 const RunOptions &options)
{
  const double start_cpu_seconds = cpu_seconds(communicator);
  const Scene scene              = read_scene(file);
  auto data                      = reference_data_of(scene); // before the work, not after it
  Simulation simulation(communicator, scene);
  prepare_result_folder(communicator, scene.output.directory, file, options.force);
  if (!options.quiet && rank_in(communicator) == 0)
    tell_sizes(scene);
  // A run wants to begin: 3 % of the strain error are good enough. The test moves the nodes and
  // brings them back, so it comes before all that only looks at the simulation.
  auto interfaces = interface_reports(communicator, simulation, /*residual_left=*/3e-2);
  auto summary    = Run(communicator, simulation, std::move(interfaces), std::move(data),
                        options)(start_cpu_seconds);
  if (scene.output.pictures)
    draw_pictures(communicator, scene.output.directory, options.quiet);
  if (scene.output.report)
    write_report(communicator, scene.output.directory, options.quiet);
  return summary;
}
} // namespace ricochet
