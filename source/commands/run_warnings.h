// SPDX-License-Identifier: LGPL-2.1-or-later
// Watches a run for what makes its results doubtful, and warns of it once.
#pragma once

#include "ricochet/simulation/hourglass_watch.h"

#include <string>
#include <vector>

namespace ricochet
{
class RunWarnings
{
public:
  explicit RunWarnings(MPI_Comm communicator) : communicator_(communicator) {}

  /// Contact: call once per step, after compute_forces(). Collective.
  void update(const Simulation &simulation);
  /// Energies: call at records. Collective.
  void update(const Moment &moment);

  /// Saves or restores what has been seen and warned of.
  void exchange_state(StateArchive &archive);

  double deepest() const { return deepest_; } // penetration of a point so far [dx]
  /// Since when a projectile has touched finite elements; negative: never [s].
  double on_elements_since() const { return on_elements_since_; }
  /// The largest so far.
  const HourglassShare &hourglass() const { return hourglass_.largest(); }

  /// All that have been given so far.
  const std::vector<std::string> &given() const { return given_; }

private:
  void say(const std::string &text);
  void check_depth(const Simulation &simulation);
  void check_elements(const Simulation &simulation, std::size_t projectile);
  void check_yield(const Simulation &simulation, std::size_t projectile);
  void check_projectiles(const Simulation &simulation);

  MPI_Comm communicator_;
  double deepest_ = 0., on_elements_since_ = -1.;
  bool projectiles_meet_ = false, yields_ = false; // a projectile would
  HourglassWatch hourglass_;
  std::vector<std::string> given_;
};
} // namespace ricochet
