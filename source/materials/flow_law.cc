// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/materials/flow_law.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
double relaxed_by_flow(const FlowLaw &law, const double tau, const double pressure,
                       const double shear_modulus, const double dt)
{
  const double over = tau - law.pressure_slope * std::max(0., pressure), stiff = shear_modulus * dt;
  // excess(y) = A exp(n y) + mu dt exp(y) - over, y = log(g/g_0): convex and rising, so that
  // Newton's method comes down to the root from the first place where one of the two terms alone is
  // `over`.
  if (over <= law.stress + stiff)
    return 0.;
  const double n = law.rate_exponent;
  double y       = std::min(std::log(over / stiff), std::log(over / law.stress) / n);
  for (int iteration = 0; iteration < 50; ++iteration)
  {
    const double hard = law.stress * std::exp(n * y), viscous = stiff * std::exp(y);
    const double step = (hard + viscous - over) / (n * hard + viscous);
    y -= step;
    if (step < 1e-12)
      break;
  }
  return std::clamp(stiff * std::exp(y) / tau, 0., 1.);
}

double least_yielding_stretch(const FlowLaw &law, const double shear_modulus)
{
  return law.stress / (std::sqrt(15.) * shear_modulus);
}
} // namespace ricochet
