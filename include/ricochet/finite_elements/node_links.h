// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of a mesh as seen by a rank that needs them for something else than its own elements: their
// values are fetched from the owners, and what is added to them goes back.
#pragma once

#include "ricochet/finite_elements/hex_mesh.h"

#include <mpi.h>

namespace ricochet
{
class NodeLinks
{
public:
  NodeLinks() = default;
  /// `nodes`: global numbers, ascending, each once. Collective.
  NodeLinks(MPI_Comm communicator, const HexMesh &mesh, const std::vector<std::int64_t> &nodes);

  /// Three values per node, from the owners' (as in HexMesh) into the order of `nodes`. Collective.
  void fetch(const std::vector<double> &values, std::vector<double> &seen);
  /// The transpose: adds to the owners' values what all ranks have together, the same on any number
  /// of ranks as long as a node is seen by two at most. Collective.
  void add(const std::vector<double> &seen, std::vector<double> &values);

private:
  /// The nodes of one other rank, or of this one: a run of `nodes`.
  struct Run
  {
    int rank;
    std::size_t first, last;
  };
  struct Lent
  {
    int rank;
    std::vector<int> nodes; // local numbers of owned nodes
    std::vector<double> values;
    std::vector<int> sums; // numbers in summed_
  };

  void number_sums();

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_              = 0;
  std::vector<int> own_; // local numbers of this rank's own nodes, in the run of this rank
  std::vector<Run> runs_;
  std::vector<int> own_sums_;
  std::vector<Lent> lent_;   // to other ranks
  std::vector<int> summed_;  // owned nodes that any rank sees, ascending
  std::vector<double> sums_; // at summed_, workspace
};
} // namespace ricochet
