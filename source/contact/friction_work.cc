// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/friction_work.h"

#include "field_values.h"
#include "ricochet/contact/pair_law.h"

namespace ricochet
{
void FrictionWork::add(const PeridynamicBody &body, const std::ptrdiff_t point,
                       const Vector3 &force)
{
  forces_.push_back({&body, point, force, at(body.state().arrays.velocity, point)});
}

void FrictionWork::record(const double dt)
{
  for (const auto &[body, point, force, before] : forces_)
    work_[body->lattice().plane_of(point)][0] +=
        work_of_step(force, before, at(body->state().arrays.velocity, point), dt);
}

void FrictionWork::move_home(const PeridynamicBody &body)
{
  const Lattice &lattice = body.lattice();
  work_.move_home(body.communicator(), lattice.first_plane(),
                  lattice.first_plane() + lattice.n_planes());
}

void FrictionWork::exchange_state(StateArchive &archive, const PeridynamicBody &body)
{
  PlaneArchive(archive, body.communicator(), body.lattice()).sums("friction work", work_);
}
} // namespace ricochet
