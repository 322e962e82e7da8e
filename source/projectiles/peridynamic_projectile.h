// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile of peridynamic points that do not break, all of it or its front part with a shank of
// finite elements behind (coupling/coupled_projectile_body.h): a lattice in the projectile's own
// axes, cut to its shape, which flies rotated. Plates touch a skin, the faceted surface of the
// shape, not the points' steps: each node of the skin follows the points around it by weights that
// reproduce every linear motion (moving least squares), or is a node of the elements, and its force
// goes back by the same weights, so that force, moment and work are kept. Friction is therefore
// that of all projectiles.
#pragma once

#include "deformable_projectile.h"
#include "ricochet/coupling/coupled_projectile_body.h"

namespace ricochet
{
class PeridynamicProjectile : public DeformableProjectile
{
public:
  /// `mesh` gives the skin and the elements, if any; `start` is the motion of the origin of the
  /// body axes. Throws InputError as CoupledProjectileBody does.
  PeridynamicProjectile(MPI_Comm communicator, const Scene &scene, const HexSolid &mesh,
                        const Motion &start, const FrictionLaw &law,
                        const std::vector<PlateContact> &plates);

  void compute_internal_forces(const ForceRequest &request) override;

  double squared_frequency() const override { return squared_frequency_; }
  std::string parts() const override;
  double seconds_per_step() const override { return seconds_per_step_; }

private:
  /// A mass point that a node of the skin follows.
  struct Support
  {
    int node, mass_point;
    bool image;    // its image across y = 0
    double weight; // [-]
  };

  using MassPoint = CoupledProjectileBody::MassPoint;

  Body &deformed() override { return *body_; }
  const Body &deformed() const override { return *body_; }
  SurfaceNodes nodes() override
  {
    return {skin_position_, skin_velocity_, skin_force_, skin_mobility_};
  }
  std::vector<double> present_velocities(double kick) override;
  void distribute_surface_forces() override;
  void update_surface() override;
  Motion nearest_motion(double kick) const override;

  void build_skin(const std::vector<Vector3> &nodes, const std::vector<int> &mesh_nodes);
  bool follow_points(int node, const Vector3 &place, double range);
  void place(const Motion &start);
  double bound_contact();
  /// The skin's nodes, three numbers each, take over a quantity of the mass points.
  template <class Value>
  void follow(std::vector<double> &on_skin, const Value &value) const;

  bool mirrored_;
  std::unique_ptr<CoupledProjectileBody> body_; // whole on every rank
  std::vector<Support> skin_;                   // by node
  std::vector<double> skin_position_, skin_velocity_, skin_force_;
  std::vector<double> skin_mobility_; // per node [1/kg]
  std::vector<char> on_plane_;        // per node, the mirror plane
  double squared_frequency_ = 0., seconds_per_step_ = 0.;
};
} // namespace ricochet
