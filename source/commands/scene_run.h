// SPDX-License-Identifier: LGPL-2.1-or-later
// A run from step to step: what is due when, what is watched, what is written.
#pragma once

#include "checkpoints.h"
#include "interruption.h"
#include "reference_comparison.h"
#include "ricochet/output/field_writer.h"
#include "ricochet/output/history.h"
#include "ricochet/output/progress.h"
#include "ricochet/simulation/run_summary.h"
#include "run.h"
#include "run_warnings.h"
#include "schedule.h"

#include <chrono>
#include <optional>

namespace ricochet
{
/// Processor time of all ranks so far: what a run costs, also where others use the machine [s].
/// Collective.
PhaseClock::Seconds time_spent(MPI_Comm communicator);

class SceneRun
{
public:
  /// Of a simulation at its start, which must outlive this object. The folder of the results is
  /// prepared; `parameters`: all that is used, as text.
  SceneRun(MPI_Comm communicator, Simulation &simulation, std::vector<InterfaceReport> interfaces,
           std::optional<ReferenceData> data, const RunOptions &options,
           const std::string &parameters);

  /// Saves or restores the run with its simulation, and all that it has written. Collective.
  void exchange_state(StateArchive &archive);

  /// To the end; `start` is what had been spent before. Returns the summary.
  nlohmann::ordered_json operator()(const PhaseClock::Seconds &start);

private:
  void loop(Progress &progress);
  bool must_stop(const Interruption::Wishes &wishes);
  void judge();
  void note_positions();
  void keep_checkpoint(const Interruption::Wishes &wishes, bool stops);
  void record();
  bool is_picture_due() const;
  void write_frame();
  double bond_rate() const;
  void show(Progress &progress) const;
  nlohmann::ordered_json finish(const PhaseClock::Seconds &start);

  MPI_Comm communicator_;
  RunOptions options_;
  Simulation &simulation_;
  const Scene &scene_;
  std::vector<OutcomeWatch> watches_; // of each projectile
  DamageReport damage_;
  RunWarnings warnings_;
  std::filesystem::path directory_;
  History history_;
  FieldWriter frames_;
  Checkpoints checkpoints_;
  Schedule records_due_, frames_due_;
  Totals totals_; // of the last record
  std::optional<ReferenceData> data_;
  RunNotes notes_;
  PhaseClock::Seconds earlier_{}; // before a resume [s]
  long first_step_ = 0;           // of this process
  std::string stop_reason_;
  bool decided_ = false;                 // and therefore at an end
  std::vector<OutcomeVerdict> verdicts_; // of each, at the end
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};
} // namespace ricochet
