// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run will take, before it runs: as `check` and `study --dry-run` say it.
#pragma once

#include "ricochet/simulation/simulation.h"

namespace ricochet
{
struct RunPrice
{
  double steps;        // at most: a run ends earlier when its outcome is decided
  double bond_seconds; // wall-clock time of the bonds alone [s]
  double seconds;      // with debris contact and output [s]
  double core_seconds; // the same of all ranks together [s]
  double memory;       // of all ranks, the most so far [bytes]
};

/// Of a simulation that has been built, from the speed that it has measured. Collective.
RunPrice price_of(MPI_Comm communicator, const Simulation &simulation);

/// Lets the memory in the next price be that of what is built from now on, where the system allows
/// that (Linux from 4.0); otherwise it stays the most that this process has ever had.
void forget_most_memory();
} // namespace ricochet
