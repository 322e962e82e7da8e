// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the points of a peridynamic body with the surface of a deformable projectile: the
// pairs of contact/rigid_contact.h, with the surface's own triangles instead of an analytic shape.
//
// With the nearest point c = sum N_a x_a, distance phi and normal n, the normal force has the
// potential k (dx/2 - phi)^2/2 and acts on the nodes as -N_a f_n n, exactly its gradient. Friction
// acts at the point's centre, as on a rigid projectile, at the distance phi from the surface; its
// moment phi n x f_t about c becomes a couple of forces along n on the face's nodes. So forces and
// moments of points and nodes cancel to rounding, and the sliding speed is the one on which these
// very forces do work.
//
// Normal forces come first, of all plates, then friction, bounded as in contact/rigid_contact.h:
// here A = 1/m + T M^-1 T^T with the nodes' masses M and T of what a touch does to them, and its
// row sums are the bound.
//
// The projectile is the same on every rank; what the ranks' points do to it is gathered and added
// in the order of the points, hence independent of the number of ranks.
#pragma once

#include "ricochet/contact/contact_record.h"
#include "ricochet/contact/friction_law.h"
#include "ricochet/contact/friction_work.h"
#include "ricochet/contact/pair_law.h"
#include "ricochet/geometry/faceted_surface.h"

namespace ricochet
{
/// What a body shows to its contacts: the nodes of its surface, three numbers each but for the
/// last.
struct SurfaceNodes
{
  const std::vector<double> &position; // [m]
  const std::vector<double> &velocity; // [m/s]
  std::vector<double> &force;          // [N], added to
  /// Per node, the most that impulses of one size at all nodes change its velocity, of the whole
  /// body also with a mirror plane [1/kg].
  const std::vector<double> &mobility;
};

class SurfaceContact
{
public:
  using Parameters = PairLaw<double>; // of each pair

  /// Arguments as for RigidContact. `is_shank`: of each face of the surface.
  SurfaceContact(MPI_Comm communicator, const FrictionLaw &law, const Parameters &parameters,
                 bool mirrored, int n_planes, const std::vector<char> &is_shank);

  /// Adds the normal forces to the points and, whole, to the body; `surface` is up to date and
  /// looks a spacing far or more: a point that has come deeper is followed by a search of all
  /// faces. Returns how many touches share the node that has most of them [-]. Collective.
  double add_normal_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                           PeridynamicBody &plate);

  /// Adds the friction of the same points, whose forces are complete otherwise. The plate must
  /// outlive the next record_work(). Returns what the points do to the body. Collective.
  ///
  /// @param body     With the velocities at the time of the forces, as far as friction does not
  ///                 change them.
  /// @param shares   Sum over plates of what add_normal_forces() has returned.
  /// @param surface  As there.
  /// @param centre   Moments are about it [m].
  /// @param plate    As there.
  /// @param dt       The coming kick [s]; 0: Coulomb's law at these velocities.
  ContactRecord add_friction(const SurfaceNodes &body, double shares, const FacetedSurface &surface,
                             const Vector3 &centre, PeridynamicBody &plate, double dt);

  /// Both, where there is one plate. Collective.
  ContactRecord add_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                           const Vector3 &centre, PeridynamicBody &plate, double dt);

  /// Adds the friction work of this step to the ledger: call after the points' kick, which is `dt`
  /// long [s].
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

  /// Friction and shank forces on the nodes at the last add_forces(), three numbers each, without
  /// the mirrored half [N].
  const std::vector<double> &friction_on_nodes() const { return friction_; }

private:
  /// A point in touch, as this half of the body sees it.
  struct Touching
  {
    std::ptrdiff_t point;
    bool crossed; // the symmetry plane: it is the image that touches this half
    FacetedSurface::Hit hit;
    double depth; // [m]
  };
  /// What the normal force of one point does to the body; sent between ranks.
  struct NormalLoad
  {
    double face;
    double on_nodes[12]; // [N]
    double reach[4];     // sizes of the velocities that unit impulses along the face give [-]
    double energy;       // [J]
  };
  /// The same of its friction.
  struct FrictionLoad
  {
    double face;
    double on_nodes[12];         // with shank [N]
    double coulomb[3], shank[3]; // on the body [N]
  };

  void find_touching(const FacetedSurface &surface, const PeridynamicBody &plate);
  NormalLoad press(const Touching &touching, const FacetedSurface &surface, PeridynamicBody &plate);
  FrictionLoad rub(const Touching &touching, const SurfaceNodes &body, double shares,
                   const FacetedSurface &surface, PeridynamicBody &plate, double dt);
  ContactRecord record(const SurfaceNodes &body, const FacetedSurface &surface,
                       const Vector3 &centre) const;

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  PairLaw<double> pair_law_;
  double multiplicity_; // 2 with a symmetry plane
  std::vector<char> is_shank_;
  std::vector<Touching> touching_;       // of this rank's points
  std::vector<std::ptrdiff_t> deep_;     // points whose centre is inside: the surface may lose them
  std::vector<NormalLoad> normal_loads_; // of all ranks
  std::vector<FrictionLoad> friction_loads_; // of all ranks
  std::vector<double> friction_;             // on the nodes
  FrictionWork work_;
  double deepest_ = 0., on_elements_ = 0.; // of all ranks
  double spacing_ = 0.;                    // of the plate's points [m]
};
} // namespace ricochet
