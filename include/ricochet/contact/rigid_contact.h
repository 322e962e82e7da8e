// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the points of peridynamic bodies with a rigid body: points are spheres of diameter dx,
// the rigid body is its smooth surface. Each point in touch gets the forces of contact/pair_law.h
// with depth = dx/2 - distance and k = factor E dx, the shank's on the cylindrical part alone; the
// rigid body gets the opposite with its moment.
//
// Normal forces come first, of all plates, then friction, which knows what everything else is about
// to do: it acts against the sliding velocity u at the time of the forces, half a kick without
// friction after the velocities of the leapfrog scheme. With A, the change of all points' sliding
// velocities by impulses of friction f dt, its work in the step is
//
//   dt f . (u + dt A f/2),   A = 1/m + J M^-1 J^T <= 1/m + largest eigenvalue of M^-1 sum J^T J
//
// (m of a point, M of the body with its inertia, J the velocity of the touched place by that of the
// body, across the normal). With f = -c u and c <= 1/(dt A) that is never positive, however hard
// the two are pressed and however large the coefficient: friction may make them stick.
#pragma once

#include "ricochet/bodies/rigid_body.h"
#include "ricochet/contact/contact_record.h"
#include "ricochet/contact/friction_law.h"
#include "ricochet/contact/friction_work.h"
#include "ricochet/contact/pair_law.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <vector>

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

  /// What the points in touch, of one or more plates, do to the body before there is friction;
  /// both halves.
  struct Press
  {
    Vector3 force   = Vector3::Zero(); // [N]
    Vector3 moment  = Vector3::Zero(); // about the centroid [N m]
    /// Sum of J^T J, translation [-] before rotation [m, m^2].
    Matrix6 sliding = Matrix6::Zero();

    /// Adds that of another plate.
    Press &operator+=(const Press &other);
  };

  /// Adds the normal forces to the points. What the body gets is in the record of add_friction(),
  /// which must follow. Collective.
  Press add_normal_forces(const RigidBody &projectile, PeridynamicBody &plate);

  /// Adds the friction of the same points, which must outlive the next record_work(); their forces
  /// are complete otherwise. Returns all that they do to the body. Collective.
  ///
  /// @param projectile  As it was for the normal forces.
  /// @param press       Of all plates.
  /// @param plate       Whose normal forces were added last with this object.
  /// @param dt          The coming kick [s]; 0: Coulomb's law at the present velocities.
  ContactRecord add_friction(const RigidBody &projectile, const Press &press,
                             PeridynamicBody &plate, double dt);

  /// Both, where there is one plate. Collective.
  ContactRecord add_forces(const RigidBody &projectile, PeridynamicBody &plate, double dt);

  /// Adds the friction work the points received in this step to the ledger: call after their kick,
  /// which is `dt` long [s].
  void record_work(const double dt) { work_.record(dt); }
  /// As Interaction::bodies_changed(), of the plate it has to do with.
  void plate_changed(const PeridynamicBody &plate) { work_.move_home(plate); }
  /// As Interaction::exchange_state(), likewise.
  void exchange_state(StateArchive &archive, const PeridynamicBody &plate)
  {
    work_.exchange_state(archive, plate);
  }
  /// Work of friction and shank forces on the points so far, both halves [J]. Collective.
  double work_on_points() const { return multiplicity_ * work_.total(communicator_); }

private:
  struct Touching
  {
    std::ptrdiff_t point;
    Vector3 arm, normal; // from the centroid to the point [m]; of the surface, outward [-]
    bool on_shank;
    double depth; // [m]
  };

  void touch(std::ptrdiff_t point, const BodyOfRevolution::Hit &hit, double depth,
             const RigidBody &projectile, PeridynamicBody &plate);
  void rub(const Touching &touching, const RigidBody::Motion &present, double compliance,
           PeridynamicBody &plate, double dt);
  /// Of both halves.
  void add_mirrored_half(Press &press) const;
  void add_mirrored_half(ContactRecord &record) const;

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  PairLaw<double> pair_law_;
  double multiplicity_; // 2 with a symmetry plane
  std::vector<Touching> touching_;
  PlaneSums<29> normal_sums_;  // force, moment, energy, points, upper half of `sliding`
  PlaneSums<9> friction_sums_; // friction, shank, moment of both
  FrictionWork work_;
  ContactRecord record_; // at first of the normal forces, at last of all
};
} // namespace ricochet
