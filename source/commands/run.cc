// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run.h"

#include "interruption.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/field_writer.h"
#include "ricochet/output/history.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/progress.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/output/summary.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/damage_report.h"
#include "ricochet/simulation/interface_report.h"
#include "ricochet/simulation/outcome.h"
#include "ricochet/simulation/simulation.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace ricochet
{
namespace
{
using namespace units;

/// Of a time [s]; negative: never.
nlohmann::ordered_json in_us_or_null(const double time)
{
  return time >= 0. ? nlohmann::ordered_json(time / us) : nullptr;
}

const std::vector<History::Column> history_columns{{"time", "us"},
                                                   {"x", "mm"},
                                                   {"y", "mm"},
                                                   {"z", "mm"},
                                                   {"speed", "m/s"},
                                                   {"velocity x", "m/s"},
                                                   {"velocity y", "m/s"},
                                                   {"velocity z", "m/s"},
                                                   {"pitch", "deg"},
                                                   {"spin x", "rad/s"},
                                                   {"spin y", "rad/s"},
                                                   {"spin z", "rad/s"},
                                                   {"tip depth", "mm"},
                                                   {"force normal", "kN"},
                                                   {"force friction", "kN"},
                                                   {"force shank", "kN"},
                                                   {"force x", "kN"},
                                                   {"force y", "kN"},
                                                   {"force z", "kN"},
                                                   {"energy projectile", "J"},
                                                   {"energy elastic", "J"},
                                                   {"energy kinetic", "J"},
                                                   {"energy strain", "J"},
                                                   {"energy hourglass", "J"},
                                                   {"loss conversion", "J"},
                                                   {"energy contact", "J"},
                                                   {"energy debris", "J"},
                                                   {"work friction", "J"},
                                                   {"work debris friction", "J"},
                                                   {"energy fracture", "J"},
                                                   {"energy viscous", "J"},
                                                   {"energy absorbed", "J"},
                                                   {"energy residual", "J"},
                                                   {"residual relative", "-"},
                                                   {"broken bonds", "-"}};

// Penetration which cannot be right any more: the balance is off by a quarter of all energy there
// was.
constexpr double runaway_share = 0.25;

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

class Run
{
public:
  Run(const MPI_Comm communicator, const ParameterFile &file, const RunOptions &options) :
    communicator_(communicator), start_cpu_seconds_(cpu_seconds(communicator)), file_(file),
    options_(options), scene_(read_scene(file)), simulation_(communicator, scene_),
    watch_(simulation_), damage_(communicator, simulation_), directory_(scene_.output.directory)
  {
    MPI_Comm_size(communicator, &n_ranks_);
    prepare_result_directory(communicator, directory_, options.force);
    on_first_rank(communicator,
                  [&]
                  {
                    std::ostringstream used;
                    write_used_parameters(file, used);
                    write_file(directory_ / "used.prm", used.str());
                  });
    history_       = std::make_unique<History>(communicator, directory_, history_columns);
    frames_        = std::make_unique<FieldWriter>(communicator, directory_, scene_.output.vtu);
    n_points_      = simulation_.n_points();
    n_bonds_       = damage_.n_bonds();
    start_momenta_ = simulation_.momenta();
    // A run wants to begin: 3 % of the strain error are good enough.
    interfaces_    = interface_reports(communicator, simulation_, /*residual_left=*/3e-2);
  }

  nlohmann::ordered_json operator()()
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
      finish({Outcome::undecided, "none", 0, error.what()}, /*failed=*/true);
      throw;
    }
    progress.finish();
    const auto summary = finish(watch_.verdict(stop_reason_), /*failed=*/false);
    if (scene_.output.pictures)
      draw_pictures(communicator_, directory_, options_.quiet);
    return summary;
  }

private:
  void loop(Progress &progress)
  {
    Interruption interruption;
    for (bool last = false;;)
    {
      const bool record_due  = last || simulation_.time() >= next_record_;
      const bool picture_due = is_picture_due();
      const bool frame_due   = picture_due || (scene_.output.frame_interval > 0. &&
                                             (last || simulation_.time() >= next_frame_));
      simulation_.evaluate(record_due);
      watch_.update();
      warn_about_contact();
      if (record_due)
        record();
      if (frame_due)
        write_frame();
      if (picture_due)
        note_position();
      show(progress);
      if (last)
        return;

      simulation_.advance();
      if (interruption.requested(communicator_))
      {
        interrupted_ = true;
        stop_reason_ = "interrupted";
      }
      else if (simulation_.time() >= scene_.time.end_time)
        stop_reason_ = "the final time was reached";
      last = !stop_reason_.empty() || (scene_.time.stop_early && watch_.decided());
    }
  }

  void record()
  {
    while (next_record_ <= simulation_.time())
      next_record_ += scene_.output.history_interval;
    simulation_.check_finite();
    energies_            = simulation_.energies();
    broken_bonds_        = simulation_.broken_bonds();
    const auto &motion   = simulation_.projectile().motion();
    const auto &reaction = simulation_.reaction();
    const Vector3 force  = reaction.force();
    const double tip_depth =
        simulation_.target_box().second.z() - simulation_.projectile().bounding_box().first.z();
    history_->append({simulation_.time() / us,
                      motion.position.x() / mm,
                      motion.position.y() / mm,
                      motion.position.z() / mm,
                      motion.velocity.norm(),
                      motion.velocity.x(),
                      motion.velocity.y(),
                      motion.velocity.z(),
                      simulation_.projectile().pitch() / deg,
                      motion.spin.x(),
                      motion.spin.y(),
                      motion.spin.z(),
                      tip_depth / mm,
                      reaction.normal.norm() / 1e3,
                      reaction.friction.norm() / 1e3,
                      reaction.shank.norm() / 1e3,
                      force.x() / 1e3,
                      force.y() / 1e3,
                      force.z() / 1e3,
                      energies_.projectile,
                      energies_.elastic,
                      energies_.kinetic,
                      energies_.strain,
                      energies_.hourglass,
                      energies_.conversion,
                      energies_.contact,
                      energies_.debris,
                      energies_.friction,
                      energies_.debris_friction,
                      energies_.fracture,
                      energies_.viscous,
                      energies_.absorbed,
                      energies_.residual(),
                      residual(),
                      broken_bonds_});
    if (residual() < -runaway_share)
    {
      std::ostringstream message;
      message << "The energy runs away: at " << simulation_.time() / us << " us (step "
              << simulation_.step() << ") the model holds " << 100. * (1. - residual())
              << " % of the initial energy. " << simulation_.describe_fastest_point()
              << " Lower 'Time/Safety factor' or 'Contact/Stiffness factor'.";
      throw RunError(message.str());
    }
  }

  bool is_picture_due() const
  {
    const auto &times = scene_.output.picture_times;
    return positions_.size() < times.size() && simulation_.time() >= times[positions_.size()];
  }

  /// Where the projectile is at a stated time, or rather in the first step after it.
  void note_position()
  {
    const auto &motion = simulation_.projectile().motion();
    nlohmann::ordered_json position;
    position["stated_us"] = scene_.output.picture_times[positions_.size()] / us;
    position["time_us"]   = simulation_.time() / us;
    position["x_mm"]      = motion.position.x() / mm;
    position["y_mm"]      = motion.position.y() / mm;
    position["z_mm"]      = motion.position.z() / mm;
    position["path_mm"]   = watch_.path() / mm;
    position["speed_m_s"] = motion.velocity.norm();
    position["pitch_deg"] = simulation_.projectile().pitch() / deg;
    position["angle_deg"] =
        std::atan2(motion.velocity.z(), std::hypot(motion.velocity.x(), motion.velocity.y())) / deg;
    positions_.push_back(position);
  }

  void write_frame()
  {
    while (scene_.output.frame_interval > 0. && next_frame_ <= simulation_.time())
      next_frame_ += scene_.output.frame_interval;
    frames_->write(simulation_.time(), simulation_.points(), simulation_.surface(),
                   simulation_.elements());
  }

  double share(const double energy) const
  {
    return energies_.initial > 0. ? energy / energies_.initial : 0.;
  }
  double residual() const { return share(energies_.residual()); }

  double elapsed() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  double bond_rate() const
  {
    return 2. * n_bonds_ * simulation_.step() / std::max(elapsed(), 1e-9);
  }

  void show(Progress &progress) const
  {
    progress.update(
        {simulation_.time(), simulation_.step(), simulation_.projectile().motion().velocity.norm(),
         simulation_.projectile().pitch() / deg, broken_bonds_, residual(), bond_rate()});
  }

  /// Each warning once.
  void warn_about_contact()
  {
    const auto &reaction  = simulation_.reaction();
    const double deepest  = std::max(deepest_, reaction.deepest);
    const bool speaks     = rank_in(communicator_) == 0;
    constexpr double deep = 0.5;
    if (speaks && deepest > deep && deepest_ <= deep)
      std::fprintf(
          stderr,
          "\nwarning: at %.2f us points lie %.2f spacings deep in the projectile, more than half a "
          "spacing: contact is too "
          "soft for this impact. Raise 'Contact/Stiffness factor' or lower 'Time/Safety factor'.\n",
          simulation_.time() / us, deepest);
    deepest_ = deepest;
    if (!reaction.on_elements || on_elements_ >= 0.)
      return;
    on_elements_ = simulation_.time();
    if (speaks && scene_.zone.kind != ZoneKind::none) // who wants elements alone knows
      std::fprintf(
          stderr,
          "\nwarning: at %.2f us the projectile, at x = %.0f mm, touches finite elements, which do "
          "not break: the peridynamic zone ends too early, and what follows is not to be trusted. "
          "Set 'Coupling/Adaptive = true', or enlarge the zone.\n",
          on_elements_ / us, simulation_.projectile().motion().position.x() / mm);
  }

  /// What the elements carried and how well they were tied to the points, per plate.
  nlohmann::ordered_json zones() const
  {
    auto all = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < simulation_.plates().size(); ++i)
    {
      nlohmann::ordered_json z;
      z["zone"]            = simulation_.zones()[i].reason;
      const auto &far      = simulation_.coupled_plates()[i];
      z["share_of_volume"] = far ? double(far->zone().n_free_cells()) /
                                       static_cast<double>(far->zone().n_cells_in_all())
                                 : 1.;
      if (far)
      {
        const auto &watch         = *simulation_.adaptive_zones()[i];
        z["elements"]             = far->elements().mesh().n_global_elements();
        z["slaved_cells"]         = far->zone().n_slaved_cells();
        z["ghost_force"]          = far->calibration().ghost_after;
        z["conversions"]          = watch.n_conversions();
        z["redistributions"]      = watch.n_redistributions();
        z["conversion_loss_J"]    = watch.loss() * (scene_.symmetric ? 2. : 1.);
        z["interface_reached_us"] = in_us_or_null(watch.reached());
      }
      for (const auto &report : interfaces_)
        if (report.plate == i)
        {
          z["ghost_force"]              = report.patch.ghost_force;
          z["strain_error"]             = report.patch.strain_error;
          z["largest_frequency_rad_us"] = 1e-6 * report.frequency;
          z["step_limit_us"]            = report.step_limit / us;
          z["predicted_step_limit_us"]  = report.predicted_limit / us;
          z["share_of_cost"]            = report.share_of_cost();
          z["limits_kept"]              = report.good();
        }
      all.push_back(z);
    }
    return all;
  }

  /// Per plate, x from and to, y from and to, z from and to.
  nlohmann::ordered_json damaged_boxes() const
  {
    auto boxes = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < simulation_.plates().size(); ++i)
    {
      const auto [low, high] = simulation_.damaged_box(i);
      auto box               = nlohmann::ordered_json::array();
      for (int d = 0; d < 3 && low[d] <= high[d]; ++d)
        for (const double x : {low[d], high[d]})
          box.push_back(std::round(1e3 * x / mm) / 1e3);
      boxes.push_back(box);
    }
    return boxes;
  }

  nlohmann::ordered_json finish(const OutcomeVerdict &verdict, const bool failed)
  {
    const auto &motion        = simulation_.projectile().motion();
    const auto momenta        = simulation_.momenta();
    const double core_seconds = cpu_seconds(communicator_) - start_cpu_seconds_;
    const auto drift          = [](const Vector3 &now, const Vector3 &start)
    { return (now - start).norm() / start.norm(); };

    nlohmann::ordered_json s;
    s["title"]          = scene_.title;
    s["directory"]      = directory_.string();
    s["outcome"]        = name_of(verdict.outcome);
    s["reason"]         = verdict.reason;
    s["exit_face"]      = verdict.exit_face;
    s["exit_plate"]     = verdict.exit_plate;
    s["exit_speed_m_s"] = motion.velocity.norm();
    s["exit_angle_deg"] =
        std::atan2(motion.velocity.z(), std::hypot(motion.velocity.x(), motion.velocity.y())) / deg;
    s["pitch_deg"]              = simulation_.projectile().pitch() / deg;
    s["max_depth_mm"]           = watch_.max_depth() / mm;
    s["path_mm"]                = watch_.path() / mm;
    s["contact_duration_us"]    = watch_.contact_duration() / us;
    s["time_us"]                = simulation_.time() / us;
    s["energy_residual"]        = residual();
    s["energy_viscous"]         = share(energies_.viscous);
    s["energy_absorbed"]        = share(energies_.absorbed);
    s["momentum_drift"]         = drift(momenta.linear, start_momenta_.linear);
    s["angular_momentum_drift"] = drift(momenta.angular, start_momenta_.angular);
    s["deepest_penetration_dx"] = deepest_;
    s["on_elements_us"]         = in_us_or_null(on_elements_);
    s["broken_bonds"]           = std::llround(broken_bonds_);
    s["damaged_boxes_mm"]       = damaged_boxes();
    s["zones"]                  = zones();
    s["points"]                 = std::llround(n_points_);
    s["bonds"]                  = std::llround(n_bonds_);
    s["steps"]                  = simulation_.step();
    s["time_step_us"]           = simulation_.dt() / us;
    s["ranks"]                  = n_ranks_;
    s["instruction_set"]        = simulation_.plates()[0]->kernel().instruction_set;
    s["core_seconds"]           = core_seconds;
    s["bond_rate_per_core"]     = bond_rate() / n_ranks_;
    s["interrupted"]            = interrupted_;
    s["failed"]                 = failed;
    s["version"]                = version();
    add_damage(s);
    if (!positions_.empty())
      s["positions"] = positions_;
    write_summary(communicator_, directory_, s);
    write_damage_maps(communicator_, directory_, damage_.maps());
    history_->close();
    return s;
  }

  void add_damage(nlohmann::ordered_json &summary) const
  {
    const auto plates = damage_.plates();
    for (std::size_t i = 0; i < plates.size(); ++i)
    {
      const std::string plate               = "plate_" + std::to_string(i + 1);
      summary[plate + "_broken_share"]      = plates[i].broken_share;
      summary[plate + "_front_damaged_mm2"] = plates[i].front_area / (mm * mm);
      summary[plate + "_rear_damaged_mm2"]  = plates[i].rear_area / (mm * mm);
    }
  }

  MPI_Comm communicator_;
  double start_cpu_seconds_;
  const ParameterFile &file_;
  RunOptions options_;
  Scene scene_;
  Simulation simulation_;
  OutcomeWatch watch_;
  DamageReport damage_;
  std::filesystem::path directory_;
  std::unique_ptr<History> history_;
  std::unique_ptr<FieldWriter> frames_;
  MomentumBalance start_momenta_;
  std::vector<InterfaceReport> interfaces_; // at the start
  EnergyBalance energies_{};
  int n_ranks_;
  double n_points_, n_bonds_, broken_bonds_ = 0.;
  double next_record_ = 0., next_frame_ = 0.; // [s]
  nlohmann::ordered_json positions_ = nlohmann::ordered_json::array();
  double deepest_                   = 0.; // penetration [dx]
  double on_elements_ = -1.; // since when the projectile has touched some; negative: never [s]
  bool interrupted_   = false;
  std::string stop_reason_;

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};
} // namespace

nlohmann::ordered_json run(const MPI_Comm communicator, const ParameterFile &file,
                           const RunOptions &options)
{
  return Run(communicator, file, options)();
}

std::string describe(const nlohmann::ordered_json &s)
{
  const auto number = [&](const char *key)
  { return s[key].is_number() ? s[key].get<double>() : std::nan(""); };
  char text[1200];
  std::snprintf(
      text, sizeof text,
      "\noutcome     %s: %s\n"
      "exit        %.0f m/s at %.1f deg to the plate, pitch %.1f deg, after %.0f us; deepest %.1f "
      "mm, path %.0f mm\n"
      "balance     energy residual %.2f %% of the impact energy, momentum drift %.0e, angular "
      "momentum drift %.0e\n"
      "cost        %.0f points, %.0f steps, %.1f core-seconds, %.0f M directed bonds/s per core\n"
      "results     %s",
      s["outcome"].get<std::string>().c_str(), s["reason"].get<std::string>().c_str(),
      number("exit_speed_m_s"), number("exit_angle_deg"), number("pitch_deg"), number("time_us"),
      number("max_depth_mm"), number("path_mm"), 100. * number("energy_residual"),
      number("momentum_drift"), number("angular_momentum_drift"), number("points"), number("steps"),
      number("core_seconds"), 1e-6 * number("bond_rate_per_core"),
      s["directory"].get<std::string>().c_str());
  return text;
}
} // namespace ricochet
