// SPDX-License-Identifier: LGPL-2.1-or-later
// What is reported of the contact of points with a projectile.
#pragma once

#include "ricochet/base/vector.h"

#include <algorithm>

namespace ricochet
{
/// What the points of one or more plates do to a projectile, over all ranks; with a symmetry plane
/// the other half included. A report: the loads themselves have gone to the bodies.
struct ContactRecord
{
  Vector3 normal             = Vector3::Zero(); // [N]
  Vector3 friction           = Vector3::Zero(); // of Coulomb's law [N]
  Vector3 shank              = Vector3::Zero(); // [N]
  Vector3 moment             = Vector3::Zero(); // about the centroid, of all three [N m]
  Vector3 friction_moment    = Vector3::Zero(); // of friction and shank alone [N m]
  double energy              = 0.;              // stored in the springs of all pairs [J]
  double deepest             = 0.;    // depth of the deepest point: spacing/2 - distance [m]
  double deepest_in_spacings = 0.;    // the largest depth over the spacing of its own plate [-]
  double n_touching          = 0.;    // points
  bool on_elements           = false; // some of them follow finite elements, which do not break

  Vector3 force() const { return normal + friction + shank; } // [N]

  /// Adds what the points of another plate do.
  ContactRecord &operator+=(const ContactRecord &other)
  {
    normal += other.normal;
    friction += other.friction;
    shank += other.shank;
    moment += other.moment;
    friction_moment += other.friction_moment;
    energy += other.energy;
    deepest             = std::max(deepest, other.deepest);
    deepest_in_spacings = std::max(deepest_in_spacings, other.deepest_in_spacings);
    n_touching += other.n_touching;
    on_elements = on_elements || other.on_elements;
    return *this;
  }
};
} // namespace ricochet
