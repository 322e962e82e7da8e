// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/projectiles/projectile_contact.h"

#include "ricochet/base/phase_clock.h"

namespace ricochet
{
void ProjectileContact::add_forces(const double dt)
{
  const PhaseClock::Work work(Phase::projectiles);
  record_ = {};
  for (const auto &record : projectile_.add_contact_forces(plates_, dt))
    record_ += record;
}

void ProjectileContact::record_work(const double dt)
{
  const PhaseClock::Work work(Phase::projectiles);
  projectile_.record_work(dt);
}
} // namespace ricochet
