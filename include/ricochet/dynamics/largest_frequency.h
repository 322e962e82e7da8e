// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a body, matrix-free, with the very force routine that is integrated: an
// element-wise or bond-wise bound would waste a quarter to a half of the step.
#pragma once

#include "ricochet/bodies/body.h"

#include <mpi.h>

namespace ricochet
{
/// What the functions below find.
struct FrequencyEstimate
{
  double squared_frequency; // largest eigenvalue of M^-1 K at the reference positions [1/s^2]
  double seconds_per_force; // wall time of one force evaluation with halo exchange [s]
  int n_evaluations;        // of the forces
};

/**
 * A bound from above, for time steps. Lanczos' process from a random start v_1 gives after n steps
 * a polynomial p of degree n with p(M^-1 K) v_1 = v_n+1, a vector of length 1 as v_1 is. Hence
 * |p(lambda)| |z . v_1| <= 1 for every eigenvector z: if an eigenvalue lay beyond the x > all roots
 * with p(x) = 1/s, v_1 would have a share of less than s in its z. Of all directions in N
 * dimensions a part of sqrt(2 N/pi) s has so little; s is chosen such that this is 1 % (van
 * Dorsselaer, Hochstenbach, van der Vorst 1999).
 *
 * Ends when the bound is less than 2 % above the eigenvalue; should that take more than 30
 * evaluations of the forces, it is a little more (2.8 % with 260 000 unknowns, doc/time_step.md).
 * Rounded up to 16 bits, and so the same on any number of ranks. The body, which must not be rigid,
 * is left at rest in its reference configuration. Collective over `communicator`.
 */
FrequencyEstimate frequency_bound(MPI_Comm communicator, Body &body);

/// From below, by power iteration: nothing is presumed of K, not even that it is symmetric. After
/// 30 force evaluations up to 4 % of the eigenvalue are missing, after 300 at most 0.3 %
/// (doc/time_step.md). For experiments and tests. Otherwise as frequency_bound().
FrequencyEstimate largest_frequency(MPI_Comm communicator, Body &body, int n_iterations = 30);
} // namespace ricochet
