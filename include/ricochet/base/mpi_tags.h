// SPDX-License-Identifier: LGPL-2.1-or-later
// The tags of all messages from one rank to another, so that no two kinds share one. All of them
// go over the communicator that the caller has given.
#pragma once

namespace ricochet::mpi_tag
{
/// The halo of peridynamic body `number`, 0 <= number < most_bodies, takes two: this one for what
/// goes to the rank with the next planes, the following one for what comes back.
constexpr int halo(const int number)
{
  return 2 * number;
}

constexpr int most_bodies = 500; // halos have the tags below 1000

constexpr int contact_ghosts = halo(most_bodies); // positions of points that may touch
constexpr int lists          = 1001;              // base/exchange.h
constexpr int node_values    = 1002;              // of finite elements, to who sees them
constexpr int node_sums      = 1003;              // and back
constexpr int planes         = 1004;              // of a lattice that changes its rank
constexpr int element_sums   = 1005;              // at nodes, to the nodes' owners
constexpr int hanging_sums   = 1006;              // of hanging nodes, to their masters' owners
} // namespace ricochet::mpi_tag
