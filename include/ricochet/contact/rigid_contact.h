// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the points of a peridynamic body with a rigid body: points are spheres of diameter dx,
// the rigid body is its smooth surface. Each point in touch gets the forces of contact/pair_law.h
// with depth = dx/2 - distance and k = factor E dx, the shank's on the cylindrical part alone; the
// rigid body gets the opposite with its moment.
#pragma once

#include "ricochet/bodies/rigid_body.h"
#include "ricochet/contact/contact_record.h"
#include "ricochet/contact/friction_law.h"
#include "ricochet/contact/friction_work.h"
#include "ricochet/contact/pair_law.h"

namespace ricochet
{
class RigidContact
{
public:
  using Parameters = PairLaw<double>; // of each pair

  /// `law` must outlive this object. `mirrored`: y = 0 is a symmetry plane. `n_planes`: of the
  /// plate's lattice.
  RigidContact(MPI_Comm communicator, const FrictionLaw &law, const Parameters &parameters,
               bool mirrored, int n_planes);

  /// Adds contact forces to the points, which must outlive the next record_work(). What the rigid
  /// body gets is in the record: force() and moment. Collective.
  ContactRecord add_forces(const RigidBody &projectile, PeridynamicBody &plate);

  /// Adds the friction work the points received in this step to the ledger: call after their kick,
  /// which is `dt` long [s].
  void record_work(const double dt) { work_.record(dt); }
  /// Work of friction and shank forces on the points so far, both halves [J]. Collective.
  double work_on_points() const { return multiplicity_ * work_.total(communicator_); }

private:
  void add_point_forces(std::ptrdiff_t point, const Vector3 &position,
                        const BodyOfRevolution::Hit &hit, double depth, const RigidBody &projectile,
                        PeridynamicBody &plate);
  ContactRecord record(double spacing) const;

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  PairLaw<double> pair_law_;
  double multiplicity_; // 2 with a symmetry plane
  PlaneSums<17> sums_;  // normal, friction, shank, moment, friction's moment, energy, points
  FrictionWork work_;
  double deepest_ = 0., on_elements_ = 0.; // of this rank
};
} // namespace ricochet
