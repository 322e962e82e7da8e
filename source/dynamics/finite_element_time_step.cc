// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finite_element_time_step.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
/// Nodes have different masses: |u|^2 = sum m u^2, |f|^2 = sum f^2/m, in which M^-1 K is symmetric.
class FiniteElementVibration
{
public:
  FiniteElementVibration(const MPI_Comm communicator, FiniteElementBody &body) :
    communicator_(communicator), body_(body), mesh_(body.mesh())
  {
    double finest = mesh_.box().edge;
    for (const auto &element : mesh_.elements())
      finest = std::min(finest, element.edge);
    MPI_Allreduce(MPI_IN_PLACE, &finest, 1, MPI_DOUBLE, MPI_MIN, communicator);
    finest_    = finest;
    amplitude_ = 1e-6 * finest * std::sqrt(body.total_mass());
  }

  void excite()
  {
    // The highest modes alternate from node to node of the finest cubes, see PeridynamicVibration.
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    {
      const Vector3 c = (mesh_.reference_position(node) - mesh_.box().corner) / finest_;
      for (int d = 0; d < 3; ++d)
      {
        const double noise = std::sin(12.9898 * c[0] + 78.233 * c[1] + 37.719 * c[2] + 4.1 * d);
        const long sum =
            std::lround(c[0]) + std::lround(c[1]) * (d == 1) + std::lround(c[2]) * (d == 2);
        body_.force()[3 * node + d] = body_.mass(node) * ((sum % 2 ? -1. : 1.) + noise);
      }
    }
  }

  double response() const
  {
    double sum = 0.;
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const double f = body_.force()[3 * node + d];
        sum += f * f * body_.inverse_mass(node, d);
      }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return std::sqrt(sum);
  }

  double response_of_unit() const { return amplitude_; }

  void displace(const double norm)
  {
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i         = 3 * node + d;
        body_.position()[i] = mesh_.reference()[i] -
                              amplitude_ * body_.force()[i] * body_.inverse_mass(node, d) / norm;
      }
  }

  void evaluate()
  {
    body_.update_ghosts();
    body_.evaluate(/*energy=*/false);
  }

  void rest() { body_.rest(); }

private:
  MPI_Comm communicator_;
  FiniteElementBody &body_;
  const HexMesh &mesh_;
  double finest_; // smallest edge [m]
  // Root mean square displacement 1e-6 of the smallest edge: linear to that accuracy, and far above
  // the rounding of x in F.
  double amplitude_; // |u| [m sqrt(kg)]
};
} // namespace

FrequencyEstimate estimate_largest_frequency(const MPI_Comm communicator, FiniteElementBody &body,
                                             const int n_iterations)
{
  FiniteElementVibration vibration(communicator, body);
  return power_iteration(communicator, vibration, n_iterations);
}
} // namespace ricochet
