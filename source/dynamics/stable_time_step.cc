// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/stable_time_step.h"

#include "ricochet/discretization/plane_sums.h"

#include <chrono>
#include <cmath>

namespace ricochet
{
FrequencyEstimate estimate_largest_frequency(const MPI_Comm communicator, PeridynamicForce &body,
                                             const int n_iterations)
{
  const Lattice &lattice = body.lattice();
  auto &a                = body.state().arrays;
  // Small enough for a linear response, large enough that the extension survives the cancellation
  // |xi + eta| - |xi|. It is the root mean square over the points.
  const double amplitude =
      1e-6 * lattice.box().spacing *
      std::sqrt(double(lattice.box().n[0]) * lattice.box().n[1] * lattice.box().n[2]);
  double eigenvalue = 0.;
  double seconds    = 0.;

  const auto for_each_owned = [&](auto &&visit)
  {
    for (std::ptrdiff_t p = lattice.owned_begin(); p < lattice.owned_end(); ++p)
      if (lattice.owned(p))
        visit(p);
  };
  const auto reference = [&](const std::ptrdiff_t p)
  { return lattice.reference_position(lattice.coordinates(p)); };

  // The highest modes alternate from point to point; start near one, with a disturbance that is the
  // same for any number of ranks, so that all symmetry classes take part.
  for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const auto c = lattice.coordinates(p);
        for (int d = 0; d < 3; ++d)
        {
          const double noise = std::sin(12.9898 * c[0] + 78.233 * c[1] + 37.719 * c[2] + 4.1 * d);
          a.force[d][p]      = ((c[0] + c[1] * (d == 1) + c[2] * (d == 2)) % 2 ? -1. : 1.) + noise;
        }
      });

  for (int iteration = 0; iteration < n_iterations; ++iteration)
  {
    PlaneSums<1> sums(lattice.box().n[0]);
    for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a.force)
            sums[lattice.plane_of(p)][0] += f[p] * f[p];
        });
    const double norm = std::sqrt(sums.total(communicator)[0]);
    if (iteration > 0)
      eigenvalue = norm / (amplitude * body.point_mass());
    for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
            a.position[d][p] = x[d] - amplitude * a.force[d][p] / norm;
        });
    const auto start = std::chrono::steady_clock::now();
    body.update_ghosts();
    body.evaluate(/*breaking=*/false, /*energy=*/false);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 x = reference(p);
        for (int d = 0; d < 3; ++d)
        {
          a.position[d][p] = x[d];
          a.force[d][p]    = 0.;
        }
      });
  body.update_ghosts();
  body.state().zero(a.theta);
  seconds /= n_iterations;
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator);
  return {eigenvalue, seconds};
}
} // namespace ricochet
