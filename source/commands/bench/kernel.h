// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures the speed of the lattice kernel on this machine.
#pragma once

#include <mpi.h>
#include <string>

namespace ricochet
{
struct KernelBenchOptions
{
  int points_per_edge    = 47;    // of a cube
  int repeats            = 7;     // the median counts
  bool holes             = false; // cut a sphere out of the cube
  std::string bond_model = "linear peridynamic solid";
  std::string instruction_set;    // empty: the best one
  int branches        = 0;        // that relax; an elastic cube is then timed in turn with this one
  std::string history = "single"; // or "double"
  bool json           = false;    // one JSON object instead of text
};

/// Full time steps (halo, breaking, dilatation, force, kick and drift) of a cube in motion with
/// damage switched on. Collective; prints on rank 0. Throws InputError for an unknown law or
/// instruction set.
void bench_kernel(MPI_Comm communicator, const KernelBenchOptions &options);
} // namespace ricochet
