// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/coupled_time_step.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// Free points and nodes; |u|^2 = sum m u^2, |f|^2 = f M^-1 f, in which M^-1 K is symmetric, the
/// corrected mass of the nodes included.
class CoupledVibration
{
public:
  CoupledVibration(const MPI_Comm communicator, CoupledPlate &plate) :
    communicator_(communicator), plate_(plate), points_(plate.points()),
    elements_(plate.elements()), lattice_(points_.lattice()), a_(points_.state().arrays)
  {
    double mass = elements_.total_mass();
    double own  = 0.;
    for_each_free([&](std::ptrdiff_t) { own += points_.point_mass(); });
    MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_DOUBLE, MPI_SUM, communicator);
    // A root mean square displacement of 1e-6 spacings: linear, and far above rounding.
    amplitude_ = 1e-6 * lattice_.box().spacing * std::sqrt(mass + own);
  }

  void excite()
  {
    // The highest modes alternate from point to point; all symmetry classes take part.
    const auto start = [&](const Vector3 &X, const int d)
    {
      const Vector3 c    = (X - lattice_.box().corner) / lattice_.box().spacing;
      const double noise = std::sin(12.9898 * c[0] + 78.233 * c[1] + 37.719 * c[2] + 4.1 * d);
      const long sum = std::lround(std::floor(c[0])) + std::lround(std::floor(c[1])) * (d == 1) +
                       std::lround(std::floor(c[2])) * (d == 2);
      return (sum % 2 ? -1. : 1.) + noise;
    };
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (int d = 0; d < 3; ++d)
            a_.force[d][p] = points_.point_mass() * start(reference(p), d);
        });
    const auto &mesh = elements_.mesh();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        elements_.force()[3 * node + d] =
            elements_.mass(node) * start(0.5 * mesh.reference_position(node), d);
  }

  double response() const
  {
    double sum = elements_.squared_force();
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          for (const double *f : a_.force)
            sum += f[p] * f[p] / points_.point_mass();
        });
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return std::sqrt(sum);
  }

  double response_of_unit() const { return amplitude_; }

  void displace(const double norm)
  {
    const double factor = -amplitude_ / norm;
    for_each_free(
        [&](const std::ptrdiff_t p)
        {
          const Vector3 x = reference(p);
          for (int d = 0; d < 3; ++d)
            a_.position[d][p] = x[d] + factor * a_.force[d][p] / points_.point_mass();
        });
    const auto &mesh = elements_.mesh();
    for (int node = 0; node < mesh.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i = 3 * node + d;
        elements_.position()[i] =
            mesh.reference()[i] + factor * elements_.force()[i] * elements_.inverse_mass(node, d);
      }
  }

  void evaluate()
  {
    plate_.lead();
    points_.update_ghosts();
    points_.evaluate(/*breaking=*/false, /*energy=*/false);
    plate_.evaluate(/*energy=*/false);
  }

  void rest() { plate_.rest(); }

private:
  template <class Visitor>
  void for_each_free(Visitor &&visit) const
  {
    lattice_.for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          if (lattice_.free(p))
            visit(p);
        });
  }
  Vector3 reference(const std::ptrdiff_t p) const
  {
    return lattice_.reference_position(lattice_.coordinates(p));
  }

  MPI_Comm communicator_;
  CoupledPlate &plate_;
  PeridynamicBody &points_;
  FiniteElementBody &elements_;
  const Lattice &lattice_;
  LatticeArrays &a_;
  double amplitude_; // |u| [m sqrt(kg)]
};
} // namespace

FrequencyEstimate estimate_largest_frequency(const MPI_Comm communicator, CoupledPlate &plate,
                                             const int n_iterations)
{
  CoupledVibration vibration(communicator, plate);
  return power_iteration(communicator, vibration, n_iterations);
}
} // namespace ricochet
