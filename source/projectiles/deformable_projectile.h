// SPDX-License-Identifier: LGPL-2.1-or-later
// What all deformable projectiles have in common: a faceted surface that the plates' points touch
// (contact/surface_contact.h), and a nearest rigid motion. Every rank computes the whole body.
#pragma once

#include "ricochet/contact/surface_contact.h"
#include "ricochet/projectiles/projectile.h"

namespace ricochet
{
class DeformableProjectile : public Projectile
{
public:
  const Motion &motion() const override { return motion_; }
  std::pair<Vector3, Vector3> bounding_box() const override;
  SurfaceFrame surface() const override;

  Reaction touch(std::size_t plate, PeridynamicBody &points) override;
  void advance(const Reaction &reaction, double dt) override;
  void record_work(std::size_t plate, const PeridynamicBody &points, double dt) override;
  double friction_work() const override;

protected:
  /// `nodes` and `faces` of the surface in the reference configuration, in body axes.
  DeformableProjectile(MPI_Comm communicator, const Scene &scene, const std::vector<Vector3> &nodes,
                       const std::vector<SurfaceQuad> &faces, const FrictionLaw &law,
                       const std::vector<PlateContact> &plates);

  /// Call when the body has been put into its first place.
  void begin_motion() { follow(); }
  /// Contact stiffness that a node of the surface sees: that of the points which lie on its share
  /// of the surface, of one at least [N/m].
  double contact_stiffness(std::size_t node) const { return stiffness_[node]; }
  double multiplicity() const { return multiplicity_; }

private:
  virtual SurfaceNodes nodes() = 0;
  /// Hands the forces on the surface's nodes on to the body.
  virtual void receive() {}
  /// Kick and drift of the body and its surface.
  virtual void move(double dt)          = 0;
  virtual Motion nearest_motion() const = 0;

  void follow();
  double friction_power(); // at the present velocities, of the computed part [W]

  double multiplicity_; // 2 with a symmetry plane
  Motion motion_;
  FacetedSurface surface_;
  double reach_ = 0.;                    // how far the surface looks for points [m]
  std::vector<double> stiffness_;        // per node
  std::vector<SurfaceContact> contacts_; // per plate
  double work_ = 0.;                     // of friction on the body, both halves [J]
};

/// Faces of a mesh that points can touch: without those which the symmetry plane cuts open.
std::vector<SurfaceQuad> outer_faces(const HexSolid &mesh, bool mirrored);
} // namespace ricochet
