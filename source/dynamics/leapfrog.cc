// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/dynamics/leapfrog.h"

#include <utility>

namespace ricochet
{
Leapfrog::Leapfrog(std::vector<Body *> bodies, std::vector<Interaction *> interactions) :
  bodies_(std::move(bodies)), interactions_(std::move(interactions))
{
}

void Leapfrog::compute_forces(const Body::Outlook &outlook, const bool energy)
{
  for (auto *const body : bodies_)
    body->update_ghosts();
  bool changed = false;
  for (auto *const body : bodies_)
    changed = body->adapt(outlook) || changed;
  if (changed)
    bodies_changed();
  for (auto *const body : bodies_)
  {
    body->break_bonds();
    body->book_fracture(outlook.dt);
  }
  for (auto *const body : bodies_)
    body->compute_internal_forces({energy});
  for (auto *const interaction : interactions_)
    interaction->add_forces(outlook.dt);
  for (auto *const body : bodies_)
    body->complete_forces();
}

void Leapfrog::bodies_changed()
{
  for (auto *const interaction : interactions_)
    interaction->bodies_changed();
}

void Leapfrog::advance(const double dt)
{
  for (auto *const body : bodies_)
    body->advance(dt, dt);
  for (auto *const interaction : interactions_)
    interaction->record_work(dt);
}
} // namespace ricochet
