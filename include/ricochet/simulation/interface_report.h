// SPDX-License-Identifier: LGPL-2.1-or-later
// How well points and elements of a scene are tied together, in numbers with limits.
#pragma once

#include "ricochet/coupling/interface_patch_test.h"
#include "ricochet/simulation/simulation.h"

#include <algorithm>

namespace ricochet
{
struct InterfaceReport
{
  // Of the calibrated energy blend; the other methods are known to miss them.
  static constexpr double most_ghost_force  = 2e-3; // [-]
  static constexpr double most_strain_error = 2e-3; // [-]

  std::size_t plate;        // from 0
  PatchReport patch;        // of the patch test
  double frequency;         // largest, a bound from above [rad/s]
  double step_limit;        // 2 / frequency [s]
  double predicted_limit;   // by the dispersion of lattice and cubes, see coupling/dispersion.h [s]
  double time_step;         // of the run [s]
  double share_of_volume;   // peridynamic [-]
  double seconds_per_force; // measured, points and elements [s]
  double seconds_of_points; // measured, points alone [s]

  /// Of a force evaluation that the points take [-].
  double share_of_cost() const { return std::min(1., seconds_of_points / seconds_per_force); }
  /// Whether the ghost force keeps its limit.
  bool ghost_good() const { return patch.ghost_force <= most_ghost_force; }
  /// Whether the strain error is known and keeps its limit.
  bool strain_good() const { return patch.converged && patch.strain_error <= most_strain_error; }
  /// Whether the run's step is stable.
  bool step_good() const { return time_step < step_limit; }
  /// All of it.
  bool good() const { return ghost_good() && strain_good() && step_good(); }
};

/// Of all plates with an interface; `residual_left` as in patch_test(). Moves the nodes and brings
/// them back to rest, so only for a simulation that has not made a step. Collective.
std::vector<InterfaceReport> interface_reports(MPI_Comm communicator, Simulation &simulation,
                                               double residual_left = 1e-2);
} // namespace ricochet
