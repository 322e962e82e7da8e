// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/stable_time_step.h"

#include "ricochet/peridynamics/plane_sums.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// All points have the same mass, so the norm is the plain Euclidean one.
class PeridynamicVibration
{
public:
  PeridynamicVibration(const MPI_Comm communicator, PeridynamicBody &body) :
    communicator_(communicator), body_(body), lattice_(body.lattice()), a_(body.state().arrays),
    amplitude_(1e-6 * lattice_.box().spacing *
               std::sqrt(double(lattice_.box().n[0]) * lattice_.box().n[1] * lattice_.box().n[2]))
  {
  }

  void excite()
  {
    // The highest modes alternate from point to point; start near one, with a disturbance that is
    // the same for any number of ranks, so that all symmetry classes take part.
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const auto c = lattice_.coordinates(p);
          for (int d = 0; d < 3; ++d)
          {
            const double noise = std::sin(12.9898 * c[0] + 78.233 * c[1] + 37.719 * c[2] + 4.1 * d);
            a_.force[d][p] = ((c[0] + c[1] * (d == 1) + c[2] * (d == 2)) % 2 ? -1. : 1.) + noise;
          }
        });
  }

  double response() const
  {
    PlaneSums<1> sums(lattice_.box().n[0]);
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            sums[lattice_.plane_of(p)][0] += f[p] * f[p];
        });
    return std::sqrt(sums.total(communicator_)[0]);
  }

  double response_of_unit() const { return amplitude_ * body_.point_mass(); }

  void displace(const double norm)
  {
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] - amplitude_ * a_.force[d][p] / norm;
        });
  }

  void evaluate()
  {
    body_.update_ghosts();
    body_.evaluate(/*breaking=*/false, /*energy=*/false);
  }

  void rest()
  {
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
          {
            a_.position[d][p] = x[d];
            a_.force[d][p]    = 0.;
          }
        });
    body_.update_ghosts();
    body_.state().zero(lattice_, a_.theta);
  }

private:
  Vector3 reference(const std::ptrdiff_t p) const
  {
    return lattice_.reference_position(lattice_.coordinates(p));
  }

  MPI_Comm communicator_;
  PeridynamicBody &body_;
  const Lattice &lattice_;
  LatticeArrays &a_;
  // Small enough for a linear response, large enough that the extension survives the cancellation
  // |xi + eta| - |xi|: a root mean square over the points of 1e-6 spacings.
  double amplitude_; // |u| [m]
};
} // namespace

FrequencyEstimate estimate_largest_frequency(const MPI_Comm communicator, PeridynamicBody &body,
                                             const int n_iterations)
{
  PeridynamicVibration vibration(communicator, body);
  return power_iteration(communicator, vibration, n_iterations);
}
} // namespace ricochet
