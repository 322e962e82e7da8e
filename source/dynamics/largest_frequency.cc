// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/largest_frequency.h"

#include <chrono>

namespace ricochet
{
FrequencyEstimate largest_frequency(const MPI_Comm communicator, Body &body, const int n_iterations)
{
  const auto vibration = body.vibration();
  double eigenvalue    = 0.;
  double seconds       = 0.;
  vibration->excite();
  for (int iteration = 0; iteration < n_iterations; ++iteration)
  {
    const double norm = vibration->response();
    if (iteration > 0)
      eigenvalue = norm / vibration->response_of_unit();
    vibration->displace(norm);
    const auto start = std::chrono::steady_clock::now();
    vibration->evaluate();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  vibration->rest();
  seconds /= n_iterations;
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator);
  return {eigenvalue, seconds};
}
} // namespace ricochet
