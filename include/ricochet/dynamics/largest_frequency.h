// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a body by matrix-free power iteration with the very force routine that
// is integrated: an element-wise or bond-wise bound would waste a quarter to a half of the step.
#pragma once

#include "ricochet/bodies/body.h"

#include <mpi.h>

namespace ricochet
{
/// What largest_frequency() finds.
struct FrequencyEstimate
{
  double squared_frequency; // largest eigenvalue of M^-1 K at the reference positions [1/s^2]
  double seconds_per_force; // wall time of one force evaluation with halo exchange [s]
};

/// `n_iterations` force evaluations about the reference configuration: after 30 the step is up to
/// 1.6 % too long in a plate and 4 % with elements of several sizes, after 60 below 1 %
/// (doc/time_step.md). The body, which must not be rigid, is left at
/// rest there. Collective over `communicator`.
FrequencyEstimate largest_frequency(MPI_Comm communicator, Body &body, int n_iterations = 30);
} // namespace ricochet
