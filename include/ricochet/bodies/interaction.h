// SPDX-License-Identifier: LGPL-2.1-or-later
// What bodies do to each other: contact, in all its kinds. Forces are added to the bodies' own;
// energies are those of the full model, also with a mirror plane.
#pragma once

#include "ricochet/base/state_archive.h"

namespace ricochet
{
class Interaction
{
public:
  virtual ~Interaction() = default;

  /// Points have appeared in a body, or changed their place in memory or their rank, since the last
  /// add_forces(); the same on all ranks.
  virtual void bodies_changed() {}
  /// Adds forces to the bodies', after their internal ones. `dt`: the coming step [s]. Collective.
  virtual void add_forces(double dt)  = 0;
  /// Books the work of friction in a step, `dt` long [s]: call after the bodies' kick.
  virtual void record_work(double dt) = 0;

  /// As Body::exchange_state(), once the bodies have done it. When restoring, bodies_changed()
  /// follows.
  virtual void exchange_state(StateArchive &archive) = 0;

  /// Stored in contact springs at the last add_forces() [J]. Collective.
  virtual double energy() const        = 0;
  /// Work of friction on the bodies so far [J]; the heat is minus that. Collective.
  virtual double friction_work() const = 0;
};
} // namespace ricochet
