// SPDX-License-Identifier: LGPL-2.1-or-later
// The ledger of friction: what it works on the points of one body, the same on any number of ranks.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <vector>

namespace ricochet
{
class FrictionWork
{
public:
  /// `n_planes`: of the body.
  explicit FrictionWork(const int n_planes) : work_(n_planes) {}

  /// Forgets the forces, not the work.
  void clear() { forces_.clear(); }
  /// A force on a point of this rank in the coming kick [N]. The body must outlive the next
  /// record().
  void add(const PeridynamicBody &body, std::ptrdiff_t point, const Vector3 &force);
  /// Adds the work of these forces: call after the bodies' kick, which is `dt` long [s].
  void record(double dt);
  /// Of all steps so far [J]. Collective.
  double total(const MPI_Comm communicator) const { return work_.total(communicator)[0]; }

  /// The body's planes may have moved to other ranks. Collective.
  void move_home(const PeridynamicBody &body);
  /// Saves or restores the work. Collective.
  void exchange_state(StateArchive &archive, const PeridynamicBody &body);

private:
  struct Force
  {
    const PeridynamicBody *body;
    std::ptrdiff_t point;
    Vector3 force;    // [N]
    Vector3 velocity; // before the kick [m/s]
  };
  std::vector<Force> forces_;
  PlaneSums<1> work_; // [J]
};
} // namespace ricochet
