// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_run.h"

#include "command_line.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/units.h"
#include "ricochet/base/version.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/summary.h"
#include "ricochet/simulation/observation.h"
#include "ricochet/simulation/sanity_check.h"

#include <algorithm>

namespace ricochet
{
namespace
{
std::vector<History::Column> names_and_units(const std::size_t n_projectiles)
{
  std::vector<History::Column> columns;
  for (const auto &column : history_columns(n_projectiles))
    columns.push_back({column.name, column.unit});
  return columns;
}

/// By phase: a + b - less.
PhaseClock::Seconds sum(PhaseClock::Seconds a, const PhaseClock::Seconds &b,
                        const PhaseClock::Seconds &less = {})
{
  for (int i = 0; i < n_phases; ++i)
    a[i] += b[i] - less[i];
  return a;
}
} // namespace

PhaseClock::Seconds time_spent(const MPI_Comm communicator)
{
  auto seconds = PhaseClock::seconds();
  MPI_Allreduce(MPI_IN_PLACE, seconds.data(), n_phases, MPI_DOUBLE, MPI_SUM, communicator);
  return seconds;
}

SceneRun::SceneRun(const MPI_Comm communicator, Simulation &simulation,
                   std::vector<InterfaceReport> interfaces, std::optional<ReferenceData> data,
                   const RunOptions &options, const std::string &parameters) :
  communicator_(communicator),
  options_(options), simulation_(simulation), scene_(simulation.scene()),
  damage_(communicator, simulation), warnings_(communicator), directory_(scene_.output.directory),
  history_(communicator, directory_, names_and_units(simulation.n_projectiles())),
  frames_(communicator, directory_, scene_.output.vtu),
  checkpoints_(communicator, scene_.output, parameters),
  records_due_(scene_.output.history_interval), frames_due_(scene_.output.frame_interval),
  data_(std::move(data))
{
  for (std::size_t i = 0; i < simulation.n_projectiles(); ++i)
    watches_.push_back(watch_of(simulation, i));
  notes_.further_positions.resize(watches_.size() - 1, nlohmann::ordered_json::array());
  notes_.directory     = directory_.string();
  notes_.version       = version();
  notes_.command       = command_line();
  notes_.n_ranks       = size_of(communicator);
  notes_.n_points      = simulation.n_points();
  notes_.n_bonds       = damage_.n_bonds();
  notes_.start_momenta = simulation.momenta();
  notes_.interfaces    = std::move(interfaces);
}

void SceneRun::exchange_state(StateArchive &archive)
{
  simulation_.exchange_state(archive);
  const StateArchive::Group group(archive, "run");
  for (std::size_t i = 0; i < watches_.size(); ++i)
  {
    const StateArchive::Group projectile(archive, "projectile " + std::to_string(i + 1));
    watches_[i].exchange_state(archive);
  }
  warnings_.exchange_state(archive);
  history_.exchange_state(archive);
  frames_.exchange_state(archive);
  records_due_.exchange_state(archive, "next record");
  frames_due_.exchange_state(archive, "next frame");
  checkpoints_.exchange_state(archive);
  archive.common("totals", totals_);
  nlohmann::ordered_json all_positions{notes_.positions, notes_.further_positions};
  auto positions = all_positions.dump();
  auto spent     = sum(earlier_, time_spent(communicator_));
  archive.common("positions", positions);
  archive.common("time spent", spent);
  if (!archive.is_restoring())
    return;
  all_positions            = nlohmann::ordered_json::parse(positions);
  notes_.positions         = all_positions[0];
  notes_.further_positions = all_positions[1].get<std::vector<nlohmann::ordered_json>>();
  earlier_                 = spent;
  first_step_              = simulation_.step();
}

nlohmann::ordered_json SceneRun::operator()(const PhaseClock::Seconds &start)
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
    verdicts_.assign(watches_.size(), {Outcome::undecided, ExitFace::none, 0, error.what()});
    finish(start);
    throw;
  }
  progress.finish();
  return finish(start);
}

void SceneRun::loop(Progress &progress)
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
    for (std::size_t i = 0; i < watches_.size(); ++i)
      watches_[i].update(observe(simulation_, i));
    warnings_.update(simulation_);
    if (record_due)
      record();
    if (frame_due)
      write_frame();
    if (picture_due)
      note_positions();
    show(progress);
    if (last)
    {
      // A decision that ended the run stands, whatever the last step has brought.
      if (!decided_)
        judge();
      return;
    }

    simulation_.advance();
    const auto wishes = interruption.wishes(communicator_);
    last              = must_stop(wishes);
    keep_checkpoint(wishes, last);
  }
}

/// Whether the next step is the last one; notes why.
bool SceneRun::must_stop(const Interruption::Wishes &wishes)
{
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (wishes.stop)
    stop_reason_ = "interrupted";
  else if (scene_.time.wall_limit > 0. &&
           broadcast(communicator_, elapsed >= scene_.time.wall_limit, 0))
    stop_reason_ = "the wall-clock limit was reached";
  notes_.interrupted = !stop_reason_.empty();
  if (stop_reason_.empty() && simulation_.time() >= scene_.time.end_time)
    stop_reason_ = "the final time was reached";
  decided_ = scene_.time.stop_early &&
             std::all_of(watches_.begin(), watches_.end(),
                         [](const OutcomeWatch &watch) { return watch.decided(); });
  if (decided_)
    judge();
  return decided_ || !stop_reason_.empty();
}

/// Every projectile as it is now.
void SceneRun::judge()
{
  verdicts_.clear();
  for (const auto &watch : watches_)
    verdicts_.push_back(watch.verdict(stop_reason_));
}

void SceneRun::note_positions()
{
  const double stated_time = scene_.output.picture_times[notes_.positions.size()];
  notes_.positions.push_back(sighting(simulation_, watches_[0], stated_time));
  for (std::size_t i = 1; i < watches_.size(); ++i)
    notes_.further_positions[i - 1].push_back(sighting(simulation_, watches_[i], stated_time, i));
}

/// Before the last record, which a run that goes on does not make.
void SceneRun::keep_checkpoint(const Interruption::Wishes &wishes, const bool stops)
{
  const bool unfinished = notes_.interrupted && !decided_;
  if (!unfinished && !wishes.checkpoint && (stops || !checkpoints_.is_due(simulation_.time())))
    return;
  const PhaseClock::Work work(Phase::checkpoints);
  checkpoints_.write(simulation_.step(), simulation_.time(),
                     [this](StateArchive &archive) { exchange_state(archive); });
}

void SceneRun::record()
{
  const PhaseClock::Work work(Phase::records);
  records_due_.done(simulation_.time());
  simulation_.check_finite();
  totals_ = totals_of(simulation_);
  const Moment moment{simulation_, totals_};
  history_.append(history_record(moment));
  warnings_.update(moment);
  check_energy(moment);
}

bool SceneRun::is_picture_due() const
{
  const auto &times = scene_.output.picture_times;
  return notes_.positions.size() < times.size() &&
         simulation_.time() >= times[notes_.positions.size()];
}

void SceneRun::write_frame()
{
  const PhaseClock::Work work(Phase::frames);
  frames_due_.done(simulation_.time());
  const auto extent = frames_.extent();
  frames_.write(simulation_.time(), simulation_.points(extent), simulation_.surface(),
                simulation_.elements(extent));
}

/// Directed bonds evaluated per second of wall time, all ranks [1/s].
double SceneRun::bond_rate() const
{
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  return 2. * simulation_.computed_share() * notes_.n_bonds *
         static_cast<double>(simulation_.step() - first_step_) / std::max(elapsed, 1e-9);
}

void SceneRun::show(Progress &progress) const
{
  progress.update({simulation_.time(), simulation_.step(),
                   simulation_.projectile().motion().velocity.norm(),
                   simulation_.projectile().pitch() / units::deg, totals_.broken_bonds,
                   totals_.relative_residual(), bond_rate()});
}

nlohmann::ordered_json SceneRun::finish(const PhaseClock::Seconds &start)
{
  notes_.phases            = sum(earlier_, time_spent(communicator_), start);
  notes_.bond_rate         = bond_rate();
  notes_.deepest           = warnings_.deepest();
  notes_.on_elements_since = warnings_.on_elements_since();
  notes_.hourglass         = warnings_.hourglass();
  notes_.warnings          = warnings_.given();
  if (data_)
    on_first_rank(communicator_,
                  [&] { notes_.reference_data = compare_with_data(directory_, *data_); });
  RunEnd end{simulation_, watches_[0], verdicts_[0], totals_, notes_};
  for (std::size_t i = 1; i < watches_.size(); ++i)
    end.further.push_back({watches_[i], verdicts_[i]});
  auto summary = run_summary(end, damage_.plates());
  write_summary(communicator_, directory_, summary);
  write_damage_maps(communicator_, directory_, damage_.maps());
  history_.close();
  return summary;
}
} // namespace ricochet
