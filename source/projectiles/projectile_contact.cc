// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/projectiles/projectile_contact.h"

namespace ricochet
{
void ProjectileContact::add_forces(const double dt)
{
  record_ = {};
  for (const auto &record : projectile_.add_contact_forces(plates_, dt))
    record_ += record;
}

void ProjectileContact::record_work(const double dt)
{
  projectile_.record_work(dt);
}
} // namespace ricochet
