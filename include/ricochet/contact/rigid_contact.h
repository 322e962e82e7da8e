// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the points of a peridynamic body with a rigid body: points are spheres of diameter dx,
// the rigid body is its smooth surface. Per touching point
//   normal   f_n = k depth n,  k = factor E dx  (potential k depth^2 / 2, so the normal force
//   conserves energy) friction f_t = -mu(v_t) f_n v_t/|v_t|, linear in v_t below the regularisation
//   speed shank    f_s = -fraction mu(v_t) A dx^2 v_t/|v_t| on the cylindrical part
//   (cavity-expansion resistance A)
// with equal and opposite forces and their moments on the rigid body.
#pragma once

#include "ricochet/bodies/rigid_body.h"
#include "ricochet/contact/friction_law.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <memory>

namespace ricochet
{
class RigidContact
{
public:
  struct Parameters
  {
    double stiffness;            // k [N/m]
    double shank_force;          // fraction times A dx^2 [N]
    double regularisation_speed; // [m/s]
  };

  /// What the points do to the rigid body, over all ranks; with a symmetry plane the other half
  /// included.
  struct Reaction
  {
    Vector3 normal          = Vector3::Zero(); // [N]
    Vector3 friction        = Vector3::Zero(); // [N]
    Vector3 shank           = Vector3::Zero(); // [N]
    Vector3 moment          = Vector3::Zero(); // about the centroid, of all three [N m]
    Vector3 friction_moment = Vector3::Zero(); // of friction and shank alone [N m]
    double energy           = 0.;              // stored in the penalty springs [J]
    double deepest          = 0.; // penetration of a point's centre below the surface plus dx/2 [m]
    double n_touching       = 0.; // points
    bool on_elements        = false; // some of them follow finite elements, which do not break

    Vector3 force() const { return normal + friction + shank; }
    Reaction &operator+=(const Reaction &other);
  };

  /// `law` must outlive this object. `mirrored`: y = 0 is a symmetry plane.
  RigidContact(MPI_Comm communicator, const FrictionLaw &law, const Parameters &parameters,
               bool mirrored, int n_planes);

  /// Adds contact forces to the points and returns the reaction. Collective.
  Reaction evaluate(const RigidBody &projectile, PeridynamicBody &plate);

  /// Adds the friction work the points received in this step to the ledger: call after their kick,
  /// which is `dt` long.
  void record_work(const PeridynamicBody &plate, double dt);
  /// Work of friction and shank forces on the points so far, both halves [J]. Collective.
  double work_on_points() const;

private:
  struct ActiveContact
  {
    std::ptrdiff_t point;
    Vector3 friction; // with shank [N]
    Vector3 velocity; // before the kick [m/s]
  };

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  Parameters parameters_;
  double multiplicity_; // 2 with a symmetry plane
  PlaneSums<17> sums_;
  PlaneSums<1> work_;
  std::vector<ActiveContact> active_;
};
} // namespace ricochet
