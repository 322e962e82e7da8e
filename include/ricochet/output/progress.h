// SPDX-License-Identifier: LGPL-2.1-or-later
// What the user sees while a run goes on: one line that updates on a terminal, a line every 10 % in
// a log file.
#pragma once

#include <chrono>
#include <iosfwd>
#include <mpi.h>
#include <string>

namespace ricochet
{
/// What is shown of a run.
struct ProgressState
{
  double time;             // simulated [s]
  long steps;              // since the start [-]
  double speed;            // of the projectile [m/s]
  double pitch;            // of the projectile's axis, in degrees, as in the history [deg]
  double broken_bonds;     // each once [-]
  double energy_residual;  // relative to the initial energy [-]
  double bonds_per_second; // directed bonds evaluated per second of wall time, all ranks [1/s]
};

class Progress
{
public:
  /// How it is shown.
  enum class Style
  {
    silent,
    terminal, // one line rewritten in place
    log       // a line every 10 %
  };

  /// Prints on rank 0 to standard output, in the style that fits it; nothing if `quiet`. No
  /// function communicates.
  Progress(MPI_Comm comm, double end_time, bool quiet);

  /// Prints to a given stream, which must outlive this object, in a given style; end_time in [s].
  Progress(std::ostream &out, double end_time, Style style);

  /// May be called at each step: prints only if something is due.
  void update(const ProgressState &state);

  /// Prints the last state and ends the line. A second call does nothing.
  void finish();

private:
  using Clock = std::chrono::steady_clock;

  std::string line(const ProgressState &state) const;
  void print(const ProgressState &state);

  std::ostream &out_;
  double end_time_; // [s]
  Style style_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point printed_; // when the terminal line was last rewritten
  int next_tenth_ = 0;        // of the run, due in a log
  ProgressState last_{};
  bool any_ = false, last_printed_ = true, finished_ = false;
};
} // namespace ricochet
