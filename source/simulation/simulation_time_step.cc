// SPDX-License-Identifier: LGPL-2.1-or-later
// How long a step of a Simulation is, and what it costs.
#include "ricochet/coupling/dispersion.h"
#include "ricochet/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ricochet
{
namespace
{
double seconds_since(const std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A plate all of whose bonds are closed cracks has a higher frequency than the sound one, if its
/// Poisson's ratio is above 1/4: that bounds the step, whatever the safety factor.
double stiffening_by_cracks(const Plate &plate)
{
  return plate.points->material().cracks_push ? std::max(1., plate.points->cracked_share()) : 1.;
}
} // namespace

FrequencyEstimate Simulation::frequency_of(const Plate &plate) const
{
  auto estimate = frequency_bound(communicator_, *plate.body);
  // What a zone is at the start says little of what it becomes: the more points, the higher the
  // frequency, up to that of an infinite lattice.
  if (plate.coupled != nullptr && scene_.zone.adaptive)
    estimate.squared_frequency = std::max(
        estimate.squared_frequency, 4. / std::pow(predicted_time_step(*plate.points).points, 2));
  return estimate;
}

void Simulation::choose_time_step()
{
  double largest = 0., largest_cracked = 0.;
  std::vector<double> elastic_seconds;
  time_step_info_ = {};
  for (const auto &plate : plates_)
  {
    const auto estimate = frequency_of(plate);
    double contact      = contact_stiffness(*plate.points) / plate.points->point_mass() +
                     short_range_contact_->squared_frequency(*plate.points);
    for (const auto &joint : joints_)
      if (joint != nullptr)
        contact += joint->squared_frequency(*plate.points);
    if (estimate.squared_frequency + contact > largest)
    {
      largest                       = estimate.squared_frequency + contact;
      time_step_info_.frequency     = std::sqrt(estimate.squared_frequency);
      time_step_info_.contact_share = contact / largest;
    }
    largest_cracked = std::max(largest_cracked,
                               stiffening_by_cracks(plate) * estimate.squared_frequency + contact);
    elastic_seconds.push_back(estimate.seconds_per_force);
    frequencies_.push_back(estimate);
  }
  double stiffest = 0.; // squared frequency of a projectile [1/s^2]
  for (const auto &projectile : projectiles_)
  {
    projectile->resolve(largest);
    time_step_info_.seconds_per_step += projectile->seconds_per_step();
    stiffest = std::max(stiffest, projectile->squared_frequency());
  }
  const double safety = scene_.time.safety_factor;
  time_step_info_.plates_dt =
      std::min(safety * 2. / std::sqrt(largest), 2. / std::sqrt(largest_cracked));
  time_step_info_.projectile_dt = safety * 2. / std::sqrt(stiffest);
  dt_ = std::min(time_step_info_.plates_dt, time_step_info_.projectile_dt);
  start_relaxation(elastic_seconds);
}

void Simulation::start_relaxation(const std::vector<double> &elastic_seconds)
{
  for (std::size_t i = 0; i < plates_.size(); ++i)
  {
    double seconds = elastic_seconds[i];
    auto &body     = *plates_[i].body;
    body.start_relaxation(dt_);
    if (body.relaxes())
    {
      // A step at rest, timed when the memory has been touched, and then from no history again.
      for (int call = 0; call < 4; ++call)
      {
        const auto start = std::chrono::steady_clock::now();
        body.update_ghosts();
        body.compute_internal_forces({});
        seconds = std::max(elastic_seconds[i], seconds_since(start));
      }
      body.start_relaxation(dt_);
      MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    }
    time_step_info_.seconds_per_step += seconds;
  }
}
} // namespace ricochet
