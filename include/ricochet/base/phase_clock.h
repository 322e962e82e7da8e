// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the processor time of this process goes. Whoever does a kind of work says so for as long as
// it lasts:
//
//   const PhaseClock::Work work(Phase::debris);
//
// Work within other work counts for itself alone, so that all phases add up to the time of the
// process. There is one clock per process, as there is one processor time; nothing that is computed
// depends on it.
#pragma once

#include <array>

namespace ricochet
{
/// In the order of phase_names.
enum class Phase
{
  rest, // what nobody claims
  set_up,
  calibration,
  points,
  elements,
  zones,
  debris,
  projectiles,
  records,
  frames,
  checkpoints
};

constexpr int n_phases = 11; // of them

/// As in summary.json.
constexpr std::array<const char *, n_phases> phase_names{
    "rest",   "set-up",      "calibration", "points", "elements",   "zones",
    "debris", "projectiles", "records",     "frames", "checkpoints"};

class PhaseClock
{
public:
  /// For as long as it lives. Must end in the opposite order of beginning; one thread only.
  class Work
  {
  public:
    explicit Work(Phase phase); // begins
    ~Work();                    // what went on before goes on
    Work(const Work &)            = delete;
    Work &operator=(const Work &) = delete;

  private:
    Phase outer_; // what goes on afterwards
  };

  using Seconds = std::array<double, n_phases>; // by Phase
  /// Of processor time of this process, all of its threads, so far [s].
  static Seconds seconds();
};
} // namespace ricochet
