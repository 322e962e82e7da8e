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

  Motion present_motion(double dt) const override;
  std::vector<ContactRecord> add_contact_forces(const std::vector<PeridynamicBody *> &plates,
                                                double dt) override;
  void plates_changed(const std::vector<PeridynamicBody *> &plates) override;
  void exchange_state(StateArchive &archive) override;
  void exchange_contact_state(StateArchive &archive,
                              const std::vector<PeridynamicBody *> &plates) override;
  void record_work(double dt) override;
  double friction_work() const override;

  double multiplicity() const override { return multiplicity_; }
  void update_ghosts() override { deformed().update_ghosts(); }
  void compute_internal_forces(const ForceRequest &request) override;
  void complete_forces() override { deformed().complete_forces(); }
  void advance(double kick, double drift) override;
  Energies energies(const double dt) const override { return deformed().energies(dt); }
  Momenta momenta() const override { return deformed().momenta(); }
  std::unique_ptr<Vibration> vibration() override { return deformed().vibration(); }
  std::string first_not_finite() const override { return deformed().first_not_finite(); }

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

private:
  virtual Body &deformed()                                    = 0;
  virtual const Body &deformed() const                        = 0;
  virtual SurfaceNodes nodes()                                = 0;
  /// Velocities of the surface's nodes half a kick on, by the forces there are, three numbers each
  /// [m/s].
  virtual std::vector<double> present_velocities(double kick) = 0;
  /// The forces on the surface's nodes go to the body.
  virtual void distribute_surface_forces() {}
  /// The surface follows the body.
  virtual void update_surface() {}
  /// With the velocities half a kick on [s].
  virtual Motion nearest_motion(double kick) const = 0;

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
} // namespace ricochet
