// SPDX-License-Identifier: LGPL-2.1-or-later
// The relaxation of the shear modulus as a Prony series,
//   mu(t) = mu [ 1 - sum_k lambda_k (1 - exp(-t/theta_k)) ],
// mu being the instantaneous modulus. The bulk modulus does not relax.
#pragma once

#include "ricochet/materials/maxwell_branch.h"

#include <vector>

namespace ricochet
{
/// The branches of mu(t); none: the material is elastic.
using RelaxationSeries = std::vector<MaxwellBranch>;

/// How the history of bonds is kept: single precision takes half the memory and traffic.
enum class HistoryPrecision
{
  single_precision,
  double_precision
};

/// A branch over one step; small dt/theta without cancellation.
MaxwellStep maxwell_step(const MaxwellBranch &branch, double dt);

/// e - e_b at the time of e and g.
inline double held(const MaxwellStep &step, const double e, const double g)
{
  return (1. - step.lag) * e - g;
}
/// The same one step before, from the e of then and the g of now.
inline double held_before(const MaxwellStep &step, const double e_before, const double g)
{
  return ((1. - step.lag) * e_before - g) / step.decay;
}
/// g of the next step.
inline double next_history(const MaxwellStep &step, const double e, const double g)
{
  return step.decay * g + step.feed * e;
}

/// mu(t) / mu [-]; t infinite: the equilibrium share.
double relaxed_share(const RelaxationSeries &series, double t);

/// A branch with theta_k above `slowest_relaxation` times the duration of the run acts as elastic:
/// it loses less than 1/slowest_relaxation of its stress meanwhile.
constexpr double slowest_relaxation = 1000.;
/// Whether it does, in a run of this duration [s].
bool acts_as_elastic(const MaxwellBranch &branch, double duration);

/// The branches that do relax within the duration [s]; the share of the others is then part of the
/// equilibrium.
RelaxationSeries relaxing_within(const RelaxationSeries &series, double duration);

constexpr int max_maxwell_branches = 8; // of a series
/// Throws InputError if a share is not above 0, all shares together reach 1, a time is not above 0,
/// or there are more than max_maxwell_branches.
void check_series(const RelaxationSeries &series);

/// Throws InputError if a branch is shorter than the time step: the update stays exact, but such a
/// branch follows the strain within a step and would be a dashpot that no step resolves.
void check_step(const RelaxationSeries &series, double dt);
} // namespace ricochet
