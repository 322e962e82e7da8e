// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of the projectile with all plates, as the time integrator sees it.
#pragma once

#include "ricochet/bodies/interaction.h"
#include "ricochet/projectiles/projectile.h"

#include <vector>

namespace ricochet
{
class ProjectileContact : public Interaction
{
public:
  /// The plates' points from top to bottom; all must outlive this object.
  ProjectileContact(Projectile &projectile, std::vector<PeridynamicBody *> plates) :
    projectile_(projectile), plates_(std::move(plates))
  {
  }

  void bodies_changed() override { projectile_.plates_changed(plates_); }
  void exchange_state(StateArchive &archive) override
  {
    projectile_.exchange_contact_state(archive, plates_);
  }
  void add_forces(double dt) override;
  void record_work(double dt) override;
  double energy() const override { return record_.energy; }
  double friction_work() const override { return projectile_.friction_work(); }

  /// Of all plates, at the last add_forces().
  const ContactRecord &record() const { return record_; }

private:
  Projectile &projectile_;
  std::vector<PeridynamicBody *> plates_;
  ContactRecord record_;
};
} // namespace ricochet
