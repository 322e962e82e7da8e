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

  void begin(bool) override {}
  Reaction touch(std::size_t plate, PeridynamicBody &points) override;
  void advance(const Reaction &reaction, double dt) override;
  void record_work(std::size_t plate, const PeridynamicBody &points, double dt) override;

  Energies energies(const Reaction &reaction, double dt) const override;
  Momenta momenta() const override;
  double friction_work() const override;

  double squared_frequency() const override { return 0.; }
  std::string parts() const override { return ""; }
  double seconds_per_step() const override { return 0.; }

private:
  RigidBody rigid_;
  std::vector<RigidContact> contacts_; // per plate
  double work_ = 0.;                   // of friction on the body [J]
};
} // namespace ricochet
