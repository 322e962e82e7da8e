// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/elastic_body_time_step.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// As FiniteElementVibration: |u|^2 = sum m u^2, |f|^2 = sum f^2/m.
class ElasticVibration
{
public:
  explicit ElasticVibration(HexahedralBody &body) :
    body_(body), amplitude_(1e-6 * smallest_edge(body.solid()) * std::sqrt(body.mass()))
  {
  }

  void excite()
  {
    // Weighted by 1/m: the highest modes live where the smallest elements are.
    for (int node = 0; node < body_.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
        body_.force()[3 * node + d] = std::sin(12.9898 * node + 4.1 * d);
  }

  double response() const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < body_.force().size(); ++i)
      sum += body_.force()[i] * body_.force()[i] * body_.inverse_mass(static_cast<int>(i));
    return std::sqrt(sum);
  }

  double response_of_unit() const { return amplitude_; }

  void displace(const double norm)
  {
    for (int node = 0; node < body_.n_nodes(); ++node)
      for (int d = 0; d < 3; ++d)
      {
        const int i         = 3 * node + d;
        body_.position()[i] = body_.solid().nodes[node][d] -
                              amplitude_ * body_.force()[i] * body_.inverse_mass(i) / norm;
      }
  }

  void evaluate() { body_.evaluate(/*energy=*/false); }
  void rest() { body_.rest(); }

private:
  HexahedralBody &body_;
  double amplitude_; // |u| [m sqrt(kg)]
};
} // namespace

FrequencyEstimate estimate_largest_frequency(HexahedralBody &body, const int n_iterations)
{
  ElasticVibration vibration(body);
  return power_iteration(MPI_COMM_SELF, vibration, n_iterations);
}
} // namespace ricochet
