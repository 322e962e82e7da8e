// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/materials/relaxation.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace ricochet
{
MaxwellStep maxwell_step(const MaxwellBranch &branch, const double dt)
{
  const double x    = dt / branch.time;
  const double gone = -std::expm1(-x); // 1 - r
  double lag        = 1. - gone / x;
  if (x < 0.5)
  {
    // beta = x/2! - x^2/3! + x^3/4! - ...; 15 terms are exact to rounding here.
    lag         = 0.;
    double term = 1.;
    for (int n = 1; n <= 15; ++n)
    {
      term *= -x / (n + 1);
      lag -= term;
    }
  }
  return {branch.share, std::exp(-x), lag, gone * (1. - lag)};
}

double relaxed_share(const RelaxationSeries &series, const double t)
{
  double share = 1.;
  for (const auto &branch : series)
    share += branch.share * std::expm1(-t / branch.time);
  return share;
}

bool acts_as_elastic(const MaxwellBranch &branch, const double duration)
{
  return branch.time > slowest_relaxation * duration;
}

RelaxationSeries relaxing_within(const RelaxationSeries &series, const double duration)
{
  RelaxationSeries relaxing;
  std::copy_if(series.begin(), series.end(), std::back_inserter(relaxing),
               [&](const auto &branch) { return !acts_as_elastic(branch, duration); });
  return relaxing;
}

void check_series(const RelaxationSeries &series)
{
  std::ostringstream message;
  double sum = 0.;
  for (std::size_t k = 0; k < series.size(); ++k)
  {
    sum += series[k].share;
    if (!(series[k].share > 0.))
      message << "Relaxation share " << k + 1 << " is " << series[k].share
              << "; shares must be above 0.";
    else if (!(series[k].time > 0.))
      message << "Relaxation time " << k + 1 << " is " << series[k].time
              << " s; times must be above 0.";
    if (!message.str().empty())
      throw InputError(message.str());
  }
  if (!(sum < 1.))
    message << "The relaxation shares add up to " << sum
            << "; they must stay below 1, or nothing is left of the shear modulus in the long run.";
  else if (series.size() > std::size_t(max_maxwell_branches))
    message << "There are " << series.size() << " relaxation branches; at most "
            << max_maxwell_branches << " are possible.";
  if (!message.str().empty())
    throw InputError(message.str());
}

void check_step(const RelaxationSeries &series, const double dt)
{
  for (const auto &branch : series)
    if (branch.time < dt)
    {
      std::ostringstream message;
      message << "A relaxation time of " << 1e6 * branch.time
              << " us is shorter than the time step, " << 1e6 * dt
              << " us, so the branch would have relaxed before any step sees it. Leave it out and "
                 "lower the shear modulus by its share, "
              << branch.share << ", or refine the grid.";
      throw InputError(message.str());
    }
}
} // namespace ricochet
