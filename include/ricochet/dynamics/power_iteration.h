// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a body by matrix-free power iteration with the very force routine that
// is integrated: an element-wise or bond-wise bound would waste a quarter to a half of the step.
#pragma once

#include <chrono>
#include <mpi.h>

namespace ricochet
{
/// What a power iteration has found.
struct FrequencyEstimate
{
  double squared_frequency; // largest eigenvalue of M^-1 K at the reference positions [1/s^2]
  double seconds_per_force; // wall time of one force evaluation with halo exchange [s]
};

/// `n_iterations` force evaluations about the reference configuration (30 suffice for 1 %).
/// `Vibration` sees to the body; u stands for its displacement, f for its force, |.| for a norm of
/// its choice in which M^-1 K is symmetric:
///   void excite();                 sets f to something in which all high modes take part
///   double response() const;       |f|, summed over ranks
///   double response_of_unit();     |f| / |u| of a mode with frequency 1 rad/s, times |u|
///   void displace(double norm);    u = -|u| M^-1 f / norm, |u| small enough for a linear response
///   void evaluate();               f of the present u, halo included
///   void rest();                   u = 0, f = 0
/// Collective. The body is left at rest in its reference configuration.
template <class Vibration>
FrequencyEstimate power_iteration(const MPI_Comm communicator, Vibration &body,
                                  const int n_iterations)
{
  double eigenvalue = 0.;
  double seconds    = 0.;
  body.excite();
  for (int iteration = 0; iteration < n_iterations; ++iteration)
  {
    const double norm = body.response();
    if (iteration > 0)
      eigenvalue = norm / body.response_of_unit();
    body.displace(norm);
    const auto start = std::chrono::steady_clock::now();
    body.evaluate();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  body.rest();
  seconds /= n_iterations;
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator);
  return {eigenvalue, seconds};
}
} // namespace ricochet
