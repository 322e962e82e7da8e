// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures what a history of bonds in single precision does to their force.
#pragma once

#include <mpi.h>

namespace ricochet
{
struct HistoryBenchOptions
{
  int decades = 6; // time steps of 1 to 10^-decades relaxation times
};

/// A bond with PMMA's fast branch is pulled to 2 % within the relaxation time theta and held for
/// four more, once with its history in single and once in double precision. Prints one JSON object
/// per time step dt: the largest error of the force while it is pulled and while it is held, in
/// units of the force [-]. Rank 0 computes and prints. Throws InputError for less than 1 or more
/// than 7 decades.
void bench_history(MPI_Comm communicator, const HistoryBenchOptions &options);
} // namespace ricochet
