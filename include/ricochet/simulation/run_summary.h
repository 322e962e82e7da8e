// SPDX-License-Identifier: LGPL-2.1-or-later
// What summary.json says of a run: every field with its unit, its value and its meaning in one row.
#pragma once

#include "ricochet/base/phase_clock.h"
#include "ricochet/simulation/damage_report.h"
#include "ricochet/simulation/hourglass_watch.h"
#include "ricochet/simulation/interface_report.h"
#include "ricochet/simulation/outcome.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ricochet
{
/// What a run notes on its way, for its end.
struct RunNotes
{
  std::string directory;             // of the results
  std::string version;               // of the program
  std::string command;               // that started it
  std::vector<std::string> warnings; // that the user has been given
  int n_ranks     = 1;               // MPI processes
  double n_points = 0.;              // at time 0, see Simulation::n_points()
  double n_bonds  = 0.;              // of the sound plates at time 0
  PhaseClock::Seconds phases{};      // processor time of all ranks [s]
  double bond_rate = 0.; // directed bonds evaluated per second of wall time, all ranks [1/s]
  double deepest   = 0.; // penetration of a point into the projectile so far [dx]
  double on_elements_since = -1.;  // when the projectile first touched some; negative: never [s]
  HourglassShare hourglass;        // the largest of the run
  bool interrupted = false;        // the user ended the run
  bool failed      = false;        // the run broke down
  MomentumBalance start_momenta{}; // at time 0
  std::vector<InterfaceReport> interfaces; // at time 0
  /// From sighting(), at the times that the scene states.
  nlohmann::ordered_json positions                      = nlohmann::ordered_json::array();
  std::vector<nlohmann::ordered_json> further_positions = {}; // likewise, of projectile 2 and so on
  nlohmann::ordered_json reference_data; // comparison with somebody else's data; null: none
};

/// One of several projectiles at the end of the run.
struct ProjectileEnd
{
  const OutcomeWatch &watch;     // which has seen all steps
  const OutcomeVerdict &verdict; // what has become of it
};

/// A run at its end.
struct RunEnd
{
  const Simulation &simulation;            // at its last time
  const OutcomeWatch &watch;               // which has seen all steps of the first projectile
  const OutcomeVerdict &verdict;           // how the run has ended
  const Totals &totals;                    // of the last record
  const RunNotes &notes;                   // of the whole run
  std::vector<ProjectileEnd> further = {}; // of projectile 2 and so on
};

/// A field of the summary, as the user may read about it.
struct SummaryField
{
  std::string place;   // "", or where it stands: "zones", "positions", "projectiles", "plate_N_"
  std::string name;    // in a "plate_N_" the part behind
  std::string unit;    // "-" if dimensionless, "" if it is no number
  std::string meaning; // null values and fields that may be missing are explained here
};

/// All that a summary may have.
std::vector<SummaryField> summary_fields();

/// The summary, whose per-plate damage is `damage`. Collective.
nlohmann::ordered_json run_summary(const RunEnd &end, const std::vector<PlateDamage> &damage);

/// Where a projectile is, noted for a stated time [s], or rather in the first step after it.
nlohmann::ordered_json sighting(const Simulation &simulation, const OutcomeWatch &watch,
                                double stated_time, std::size_t projectile = 0);
} // namespace ricochet
