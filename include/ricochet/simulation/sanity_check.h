// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether the energies of a run can still be right. What is not a number is found by
// Simulation::check_finite().
#pragma once

#include "ricochet/simulation/history_record.h"

namespace ricochet
{
/// More energy than there was at the start, by this share of it, cannot be right any more: the
/// balance of a sound run closes within one percent. By taste, no paper.
constexpr double runaway_share = 0.25;

/// Throws RunError, naming the fastest point and a remedy, if the energy runs away. Collective.
void check_energy(const Moment &moment);
} // namespace ricochet
