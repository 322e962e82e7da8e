// SPDX-License-Identifier: LGPL-2.1-or-later
// How much of what the plates' elements store is in their hourglass modes. One-point elements do
// not feel these as strain; what holds them is an artificial stiffness (Flanagan and Belytschko
// 1981), and its energy ought to stay small beside that of the strain.
#pragma once

#include "ricochet/simulation/history_record.h"

namespace ricochet
{
/// The largest so far.
struct HourglassShare
{
  double share      = 0.;  // of the strain and hourglass energy of a plate's elements [-]
  double time       = -1.; // when; negative: there was none yet that matters [s]
  std::size_t plate = 0;   // whose, from 0
};

class HourglassWatch
{
public:
  /// Above it the artificial stiffness is a part of the answer: a rule of thumb of those who use
  /// explicit finite elements, no paper [-].
  static constexpr double most         = 0.1;
  /// Elements that store less than this share of the energy at the start do not matter: what a
  /// first ripple, or rounding, is made of says nothing of the run. By judgement [-].
  static constexpr double least_energy = 1e-3;

  /// Call at records. Collective.
  void update(const Moment &moment);

  /// Saves or restores the largest so far.
  void exchange_state(StateArchive &archive) { archive.common("hourglass share", largest_); }

  const HourglassShare &largest() const { return largest_; } // of any plate
  /// Whether `most` has been exceeded.
  bool is_large() const { return largest_.share > most; }

private:
  HourglassShare largest_;
};
} // namespace ricochet
