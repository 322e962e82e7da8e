// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures the contact searches on this machine: the four methods, alone and on several processes,
// on random points and on lattices of 30,000 to 900,000 points in a cube of 100 mm.
#pragma once

#include <mpi.h>
#include <string>
#include <vector>

namespace ricochet
{
struct SearchBenchOptions
{
  std::vector<int> points               = {30000, 100000, 300000, 900000};
  std::string radius                    = "3 mm";
  std::string edge                      = "100 mm"; // of the cube
  int repeats                           = 5;        // the median counts
  int most_for_brute_force              = 100000;   // points; above, it is left out
  std::vector<std::string> arrangements = {"random", "lattice"};
  bool json                             = false; // one JSON object per row instead of a table
  std::string
      picture; // PNG of seconds over points; its numbers go beside it, as .jsonl; empty: none
};

/// Every method alone and, if there are several processes, on all of them. Collective; prints on
/// rank 0. Throws InputError for impossible options and RunError if the methods' pairs differ.
void bench_search(MPI_Comm communicator, const SearchBenchOptions &options);
} // namespace ricochet
