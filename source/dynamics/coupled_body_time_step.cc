// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/coupled_body_time_step.h"

#include <cmath>

namespace ricochet
{
namespace
{
/// |u|^2 = sum m u^2, |f|^2 = sum f^2/m.
class CoupledBodyVibration
{
public:
  explicit CoupledBodyVibration(CoupledProjectileBody &body) :
    body_(body), amplitude_(1e-6 * body.spacing() * std::sqrt(body.mass()))
  {
  }

  void excite()
  {
    // Unweighted by mass: the highest modes live where there is little of it.
    double number = 0.;
    for (const auto &point : body_.mass_points())
    {
      for (int d = 0; d < 3; ++d)
        *point.force[d] = std::sin(12.9898 * number + 4.1 * d);
      ++number;
    }
  }

  double response() const
  {
    double sum = 0.;
    for (const auto &point : body_.mass_points())
      for (int d = 0; d < 3; ++d)
        sum += *point.force[d] * *point.force[d] * point.mobility[d];
    return std::sqrt(sum);
  }

  double response_of_unit() const { return amplitude_; }

  void displace(const double norm)
  {
    for (const auto &point : body_.mass_points())
      for (int d = 0; d < 3; ++d)
        *point.position[d] =
            point.reference[d] - amplitude_ * *point.force[d] * point.mobility[d] / norm;
    body_.lead();
  }

  void evaluate() { body_.evaluate(/*energy=*/false); }
  void rest() { body_.rest(); }

private:
  CoupledProjectileBody &body_;
  double amplitude_; // |u| [m sqrt(kg)]
};
} // namespace

FrequencyEstimate estimate_largest_frequency(CoupledProjectileBody &body, const int n_iterations)
{
  CoupledBodyVibration vibration(body);
  return power_iteration(MPI_COMM_SELF, vibration, n_iterations);
}
} // namespace ricochet
