// SPDX-License-Identifier: LGPL-2.1-or-later
// A rigid projectile: its motion is bodies/rigid_body.h, its surface the analytic shape.
#pragma once

#include "ricochet/projectiles/projectile.h"

namespace ricochet
{
class RigidProjectile : public Projectile
{
public:
  RigidProjectile(MPI_Comm communicator, const Scene &scene, const Motion &start,
                  const FrictionLaw &law, const std::vector<PlateContact> &plates);

  const Motion &motion() const override { return rigid_.motion(); }
  std::pair<Vector3, Vector3> bounding_box() const override { return rigid_.bounding_box(); }
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

  double multiplicity() const override { return 1.; } // whole, also with a symmetry plane
  /// There are none: forgets the load of the step before.
  void compute_internal_forces(const ForceRequest &) override { load_ = {}; }
  void advance(double kick, double drift) override;
  Energies energies(double dt) const override;
  /// With what a drive has taken up.
  Momenta momenta() const override;
  std::unique_ptr<Vibration> vibration() override { return nullptr; }
  std::string first_not_finite() const override;

  double squared_frequency() const override { return 0.; }
  std::string parts() const override { return ""; }
  double seconds_per_step() const override { return 0.; }

private:
  double drive_work(double time) const;

  RigidBody rigid_;
  std::vector<RigidContact> contacts_; // per plate
  ContactRecord load_;                 // of all plates
  double work_       = 0.;             // of friction on the body [J]
  // By what keeps a driven one going, so far:
  double drive_work_ = 0.; // [J]
  Momenta drive_impulse_;
};
} // namespace ricochet
