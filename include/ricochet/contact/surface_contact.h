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
/// What a body shows to its contacts: the nodes of its surface, three numbers each.
struct SurfaceNodes
{
  const std::vector<double> &position; // [m]
  const std::vector<double> &velocity; // [m/s]
  std::vector<double> &force;          // [N], added to
};

class SurfaceContact
{
public:
  using Parameters = PairLaw<double>; // of each pair

  /// Arguments as for RigidContact. `is_shank`: of each face of the surface.
  SurfaceContact(MPI_Comm communicator, const FrictionLaw &law, const Parameters &parameters,
                 bool mirrored, int n_planes, const std::vector<char> &is_shank);

  /// Adds contact forces to the points and, whole, to the body; `surface` is up to date and looks
  /// a spacing far or more: a point that has come deeper is followed by a search of all faces.
  /// Returns what the points do to the body; moments are about `centre`. The plate must outlive the
  /// next record_work(). Collective.
  ContactRecord add_forces(const SurfaceNodes &body, const FacetedSurface &surface,
                           const Vector3 &centre, PeridynamicBody &plate);

  /// Adds the friction work of this step to the ledger: call after the points' kick, which is `dt`
  /// long [s].
  void record_work(const double dt) { work_.record(dt); }
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
    bool crossed;     // the symmetry plane: it is the image that touches this half
    Vector3 velocity; // [m/s]
    FacetedSurface::Hit hit;
    double depth; // [m]
  };
  /// What one point does to the body; sent between ranks.
  struct Load
  {
    double face;
    double normal[12], friction[12]; // on the face's nodes; with shank [N]
    double coulomb[3], shank[3];     // on the body [N]
    double energy;                   // [J]
  };

  void find_loads(const SurfaceNodes &body, const FacetedSurface &surface, PeridynamicBody &plate);
  void add_point_load(const Touching &touching, const SurfaceNodes &body,
                      const FacetedSurface &surface, PeridynamicBody &plate);
  std::vector<Load> gather() const;
  void apply(const Load &load, const FacetedSurface &surface, const Vector3 &centre,
             const SurfaceNodes &body, ContactRecord &record);

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  PairLaw<double> pair_law_;
  double multiplicity_; // 2 with a symmetry plane
  std::vector<char> is_shank_;
  std::vector<Load> loads_;          // of this rank's points
  std::vector<std::ptrdiff_t> deep_; // points whose centre is inside: the surface may lose them
  std::vector<double> friction_;
  FrictionWork work_;
  double deepest_ = 0., on_elements_ = 0.; // of this rank
};
} // namespace ricochet
