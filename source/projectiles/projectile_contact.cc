// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/projectiles/projectile_contact.h"

namespace ricochet
{
void ProjectileContact::add_forces(double)
{
  record_ = {};
  for (std::size_t i = 0; i < plates_.size(); ++i)
    record_ += projectile_.add_contact_forces(i, *plates_[i]);
}

void ProjectileContact::record_work(const double dt)
{
  projectile_.record_work(dt);
}
} // namespace ricochet
