// SPDX-License-Identifier: LGPL-2.1-or-later
// Watches the contact of a run for what makes its results doubtful.
#pragma once

#include "ricochet/simulation/simulation.h"

namespace ricochet
{
class ContactWarnings
{
public:
  explicit ContactWarnings(MPI_Comm communicator) : communicator_(communicator) {}

  /// Call once per step, after compute_forces(). Prints each warning once, on rank 0.
  void update(const Simulation &simulation);

  double deepest() const { return deepest_; } // penetration of a point so far [dx]
  /// Since when the projectile has touched finite elements; negative: never [s].
  double on_elements_since() const { return on_elements_since_; }

private:
  void check_depth(const Simulation &simulation);
  void check_elements(const Simulation &simulation);

  MPI_Comm communicator_;
  double deepest_ = 0., on_elements_since_ = -1.;
};
} // namespace ricochet
