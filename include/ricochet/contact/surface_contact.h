// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the points of a peridynamic body with the surface of a deformable projectile: the laws
// of contact/rigid_contact.h, with the surface's own triangles instead of an analytic shape.
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

#include "ricochet/contact/rigid_contact.h"
#include "ricochet/finite_elements/hexahedral_body.h"
#include "ricochet/geometry/faceted_surface.h"

namespace ricochet
{
/// What a body shows to its contacts: the nodes of its surface, three numbers each.
struct SurfaceNodes
{
  const std::vector<double> &position; // [m]
  const std::vector<double> &velocity; // [m/s]
  std::vector<double> &force;          // [N], added to

  SurfaceNodes(const std::vector<double> &x, const std::vector<double> &v, std::vector<double> &f) :
    position(x), velocity(v), force(f)
  {
  }
  SurfaceNodes(HexahedralBody &body) : SurfaceNodes(body.position(), body.velocity(), body.force())
  {
  }
};

class SurfaceContact
{
public:
  using Parameters = RigidContact::Parameters;
  using Reaction   = RigidContact::Reaction;

  /// Arguments as for RigidContact. `is_shank`: of each face of the surface.
  SurfaceContact(MPI_Comm communicator, const FrictionLaw &law, const Parameters &parameters,
                 bool mirrored, int n_planes, const std::vector<char> &is_shank);

  /// Adds contact forces to the points and, whole, to the body; `surface` is up to date and reaches
  /// a spacing far or more: a point that has come deeper is followed by a search of all faces.
  /// Returns what the points do to the body; moments are about `centre`. Collective.
  Reaction evaluate(const SurfaceNodes &body, const FacetedSurface &surface, const Vector3 &centre,
                    PeridynamicBody &plate);

  /// Adds the friction work of this step to the ledger: call after the points' kick, which is `dt`
  /// long.
  void record_work(const PeridynamicBody &plate, double dt);
  /// Work of friction and shank forces on the points so far, both halves [J]. Collective.
  double work_on_points() const;

  /// Friction and shank forces on the nodes at the last evaluate(), without the mirrored half [N].
  const std::vector<double> &friction_on_nodes() const { return friction_; }

private:
  /// What one point does to the body; sent between ranks.
  struct Load
  {
    double face;
    double normal[12], friction[12]; // on the face's nodes; with shank [N]
    double sliding[3], shank[3];     // on the body [N]
    double energy;                   // [J]
  };
  struct ActiveContact
  {
    std::ptrdiff_t point;
    Vector3 friction; // with shank [N]
    Vector3 velocity; // before the kick [m/s]
  };

  void find_loads(const SurfaceNodes &body, const FacetedSurface &surface, PeridynamicBody &plate);
  std::vector<Load> gather() const;

  MPI_Comm communicator_;
  const FrictionLaw &law_;
  Parameters parameters_;
  double multiplicity_; // 2 with a symmetry plane
  std::vector<char> is_shank_;
  std::vector<Load> loads_; // of this rank's points
  std::vector<ActiveContact> active_;
  std::vector<std::ptrdiff_t> deep_; // points that may leave the reach of the surface inwards
  std::vector<double> friction_;
  PlaneSums<1> work_;
  double deepest_ = 0., on_elements_ = 0.;
};
} // namespace ricochet
