// SPDX-License-Identifier: LGPL-2.1-or-later
// The stability experiment: a block of points in a box of elements gets small random velocities and
// is left alone, without damping. A sound method keeps the energy; a bad one lets it grow, and the
// rate of growth is what is measured. The patch test tells how wrong a stable method is.
#pragma once

#include "ricochet/coupling/interface_patch_test.h"
#include "ricochet/scene/stability_parameters.h"

#include <mpi.h>
#include <string>

namespace ricochet
{
/// What an experiment says of its coupling.
enum class StabilityVerdict
{
  stable,
  inaccurate, // stable, but the strain or the energy is off by more than the limits below
  unstable
};

/// As in summary.json.
const char *verdict_name(StabilityVerdict verdict);

/// What counts as what.
struct StabilityLimits
{
  double rise         = 100.; // of the kinetic energy above all energy at the start: unstable [-]
  double growth       = 2.;   // of the kinetic energy over the second half: unstable [-]
  double hourglass    = 1.5;  // growth of the hourglass displacement over the same: unstable [-]
  double strain_error = 0.01; // of the patch test: inaccurate [-]
  double energy_drift = 0.01; // of the discrete energy: inaccurate [-]
};

/// What an experiment has measured.
struct StabilityResult
{
  double predicted_step; // the largest stable one by plane waves [s]
  double measured_step;  // and by power iteration [s]
  double time_step;      // used [s]
  int n_steps;           // made; fewer than asked if the energy ran away

  // Of the largest kinetic energy in each of 40 parts of the run.
  double rise;            // largest kinetic energy over all energy at the start [-]
  double growth;          // last part over the middle one [-]
  double growth_per_step; // d ln(energy) / d step over the second half of the parts [-]
  double growth_per_us;   // the same per time [1/us]
  bool ran_away;          // beyond 1e8 times the start, or not finite

  double energy_drift;     // largest |E - E_start| / E_start of the discrete energy [-]
  double hourglass_growth; // rms hourglass displacement, end over middle; 1 without such modes [-]
  PatchReport patch;       // of the same body at rest
  double smallest_eigenvalue; // of a calibrated tensor before clipping, if negative [M]
  std::int64_t n_points;      // free ones
  std::int64_t n_elements;    // without those full of points

  StabilityVerdict verdict; // by the limits
  std::string reason;       // which limit, for the user
};

/// Collective. Throws InputError for a block that cannot be built.
StabilityResult run_stability_experiment(MPI_Comm communicator,
                                         const StabilityParameters &parameters,
                                         const StabilityLimits &limits = {});
} // namespace ricochet
