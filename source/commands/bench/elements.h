// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures the speed of the finite elements on this machine.
#pragma once

#include <mpi.h>
#include <string>

namespace ricochet
{
struct ElementBenchOptions
{
  int elements_per_edge = 48; // of a cube
  int repeats           = 7;  // the median counts
  /// "one point" or "full"; "own tensors": full, each Gauss point with its own stiffness;
  /// "general": one point, distorted elements; one cube per rank, as every rank computes a
  /// projectile whole.
  std::string element   = "one point";
  std::string instruction_set; // empty: the best one
  int branches = 0;            // that relax; an elastic cube is then timed in turn with this one
  bool json    = false;        // one JSON object instead of text
};

/// Full time steps (halo, hanging nodes, forces, kick and drift) of a cube in motion, a corner of
/// which is refined once so that hanging nodes take part. Collective; prints on rank 0. Throws
/// InputError for an unknown element or instruction set.
void bench_elements(MPI_Comm communicator, const ElementBenchOptions &options);
} // namespace ricochet
