// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run will cost and what its parameters imply, without running it.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <mpi.h>

namespace ricochet
{
struct CheckOptions
{
  bool coupling = false; // also the patch test of the interface
};

/// Builds the scene, measures its time step and its speed, and prints the cost. Returns whether all
/// limits are kept. Collective; throws what run_scene() would.
bool check_scene(MPI_Comm communicator, const ParameterFile &file, const CheckOptions &options);
} // namespace ricochet
