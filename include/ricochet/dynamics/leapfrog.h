// SPDX-License-Identifier: LGPL-2.1-or-later
// The time integrator: leapfrog (central differences), explicit, of second order. Velocities are
// those of half a step before the positions. One step from x_n, v_n-1/2, of length dt:
//
//   ghosts, images and slaved points take over x_n, v_n-1/2
//   zones that damage comes near grow
//   bonds stretched beyond their limit break, for ever; what they release is booked
//   f_n       = internal forces at x_n
//   f_n      += contact
//   f_n       : what follows others hands its forces on; the mass is corrected
//   [records: energies and momenta at t_n]
//   v_n+1/2   = v_n-1/2 + dt M^-1 f_n
//   x_n+1     = x_n + dt v_n+1/2
//   the work of friction is booked
//
// The order of these calls stands in leapfrog.cc and nowhere else.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/bodies/interaction.h"

#include <vector>

namespace ricochet
{
class Leapfrog
{
public:
  /// Both must outlive this object; forces are added and sums made in this order.
  Leapfrog(std::vector<Body *> bodies, std::vector<Interaction *> interactions);

  /// Up to f_n; with `energy`, stored energies too. Collective.
  void compute_forces(const Body::Outlook &outlook, bool energy);
  /// From there to x_n+1; `dt` in s. Collective.
  void advance(double dt);

  /// All interactions hear of it.
  void bodies_changed();

private:
  std::vector<Body *> bodies_;
  std::vector<Interaction *> interactions_;
};
} // namespace ricochet
