// SPDX-License-Identifier: LGPL-2.1-or-later
// When a run writes checkpoints, where they lie, and which are kept: the last two in the folder
// "checkpoint" of the results.
#pragma once

#include "schedule.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace ricochet
{
struct OutputParameters;

/// Saves or restores all that a run goes on from.
using ExchangeState = std::function<void(StateArchive &)>;

class Checkpoints
{
public:
  /// Of the run in that folder. `parameters`: all that it uses, as text.
  Checkpoints(MPI_Comm communicator, const OutputParameters &output, std::string parameters);

  /// Whether simulated time [s] or the clock on the wall says so; the latter as rank 0 sees it.
  /// Collective.
  bool is_due(double time) const;
  /// Of the state after so many steps, at that time [s]. Earlier ones than the last two are removed
  /// then. A disk that has no room ends no run: it is warned of, and the checkpoints before stay.
  /// Collective.
  void write(long step, double time, const ExchangeState &exchange_state);

  /// Saves or restores when one is due next.
  void exchange_state(StateArchive &archive)
  {
    in_time_.exchange_state(archive, "next checkpoint");
  }

private:
  MPI_Comm communicator_;
  std::filesystem::path directory_;
  Schedule in_time_;     // simulated
  double wall_interval_; // [s]; 0: never
  std::string parameters_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A checkpoint from which a run goes on.
struct ResumedState
{
  std::filesystem::path path;
  std::unique_ptr<StateArchive> archive; // beyond the parameters
  std::string parameters;                // of the run that wrote it, as text
};

/// Whether the run in that folder has any, whole or not. Collective.
bool has_checkpoints(MPI_Comm communicator, const std::filesystem::path &directory);

/// The newest of the run in that folder that is whole; damaged ones are warned of and passed over.
/// Collective; throws FileError if there is none.
ResumedState newest_checkpoint(MPI_Comm communicator, const std::filesystem::path &directory);
} // namespace ricochet
