// SPDX-License-Identifier: LGPL-2.1-or-later
// Which points of this rank other ranks must know to find all that comes near their own. Bounding
// boxes would not do: a few fragments that have flown off blow them up. Coarse cells do.
#pragma once

#include "ricochet/base/vector.h"

#include <cstdint>
#include <mpi.h>
#include <vector>

namespace ricochet
{
/**
 * For each rank, the numbers (ascending) of those balls of this rank that may overlap one of that
 * rank's first `n_asking` balls: all that do, and some more. Nothing for this rank itself.
 * Collective.
 *
 * @param communicator Of all ranks that ask.
 * @param centres   Of this rank's balls [m]; one that is not finite overlaps none.
 * @param radii     [m]
 * @param n_asking  As many of the first balls of this rank ask what is near.
 * @param cell      Edge of the coarse cells [m], the same on all ranks; best a few radii.
 */
std::vector<std::vector<std::int32_t>> balls_near_other_ranks(MPI_Comm communicator,
                                                              const std::vector<Vector3> &centres,
                                                              const std::vector<double> &radii,
                                                              std::size_t n_asking, double cell);
} // namespace ricochet
