// SPDX-License-Identifier: LGPL-2.1-or-later
// What elements of several ranks add at the nodes where they meet, and what hanging nodes hand on
// to masters on other ranks, added up in an order that does not depend on the ranks.
#pragma once

#include "ricochet/finite_elements/hex_mesh.h"

#include <mpi.h>

namespace ricochet
{
/// Numbers that go from ranks to ranks, three at a time.
class TripleMessages
{
public:
  TripleMessages() = default;
  /// How many go to each rank; one entry per rank. Collective.
  TripleMessages(MPI_Comm communicator, int tag, const std::vector<int> &n_sent);

  /// `sent`: behind one another, in the order of the ranks they go to. Collective among those that
  /// have to do with each other.
  const std::vector<double> &exchange(const double *sent);

private:
  struct Peer
  {
    int rank, n; // numbers
  };
  MPI_Comm communicator_ = MPI_COMM_NULL;
  int tag_               = 0;
  std::vector<Peer> to_, from_;
  std::vector<double> received_;
};

/// Copies of nodes, one per element that touches one where several ranks' elements meet.
class NodeCopies
{
public:
  /// A corner of one of this rank's elements that needs a copy.
  struct Corner
  {
    int rank;           // that owns the node
    std::int64_t node;  // global number
    std::int64_t order; // of the element among those of all ranks
    int element, corner;
    int local; // number of the node here
  };

  NodeCopies() = default;
  /// `corners` are sorted here, by rank, node and order: copy i is that of corner i. Collective.
  NodeCopies(MPI_Comm communicator, std::vector<Corner> corners, std::int64_t first_owned_node,
             int n_local);

  const std::vector<Corner> &corners() const { return corners_; }

  void take_values(double *values) const;
  void add_up(double *values, const HexMesh::SummationOrder &order);
  HexMesh::SummationOrder order(const std::vector<int> &group);

private:
  struct Term
  {
    int node, group;
    std::int64_t order;
    int source;
  };

  std::vector<Corner> corners_;
  int first_copy_ = 0; // local number
  std::vector<Term> terms_;
  TripleMessages messages_;
};

/// What hanging nodes hand on to their masters.
class HangingSums
{
public:
  HangingSums() = default;
  /// `place` says where a node lies. Collective.
  HangingSums(MPI_Comm communicator, const HexMesh &mesh,
              const std::vector<std::int64_t> &owner_ends);

  /// Owned hanging nodes are zero then.
  void hand_on(double *values);

private:
  struct Share // of a hanging node in a master
  {
    int node; // local, owned
    double weight;
  };
  struct Term
  {
    int master;
    std::int64_t place; // of the hanging node
    int source;         // in what was sent to this rank, or behind: in own_
  };

  std::vector<Share> sent_, own_;
  std::vector<Term> terms_;
  std::vector<int> hanging_; // owned
  std::vector<double> packed_, own_values_;
  TripleMessages messages_;
};
} // namespace ricochet
