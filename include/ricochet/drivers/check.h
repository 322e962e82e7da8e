// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run will cost and what its parameters imply, without running it.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <mpi.h>

namespace ricochet
{
/// Builds the scene, measures its time step and its speed, and prints the cost. Collective; throws
/// what run() would.
void check(MPI_Comm communicator, const ParameterFile &file);
} // namespace ricochet
