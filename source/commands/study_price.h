// SPDX-License-Identifier: LGPL-2.1-or-later
// What the cases of a study will cost, without running them.
#pragma once

#include "ricochet/scene/study_file.h"

#include <mpi.h>

#include <vector>

namespace ricochet
{
/// Prints a line per case with its predicted price and their sum; what is finished has its own
/// price and is not counted. Builds every case that is to run, one after the other, and steps none.
/// `is_finished`: of each case. n_jobs: how many will run at a time. Collective; throws what
/// run_scene() would.
void print_prices(MPI_Comm communicator, const StudyParameters &study,
                  const std::vector<bool> &is_finished, int n_jobs);
} // namespace ricochet
