// SPDX-License-Identifier: LGPL-2.1-or-later
// A box of cubes, finer where asked, cut into one share per rank. Never changes after construction.
// Neighbouring cubes differ by at most a factor of two in edge; a node in the middle of a larger
// cube's edge or face is a hanging node and follows the corners of that edge or face, its masters.
//
// Nodal values are flat arrays, three numbers in a row per node: first the nodes this rank owns,
// then its ghosts (owned by other ranks, needed by its elements), then copies. Ranks own contiguous
// ranges of the global numbers.
//
// Where elements of several ranks meet at a node, each element has a copy of its own of that node,
// and all that it adds there goes into the copy. So the owner can add up what elements do to a node
// in the order of the elements, as one rank would, and sums do not depend on the number of ranks,
// not even by rounding. Who loops over elements sees nothing of it: a copy is the element's node.
#pragma once

#include "ricochet/base/vector.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mpi.h>
#include <vector>

namespace ricochet
{
class HexMesh
{
public:
  /// Where cubes must be small.
  struct Region
  {
    Vector3 low, high; // corners of a box in the reference configuration [m]
    int levels;        // cubes that overlap it get edge / 2^levels or finer
  };
  /// What is meshed.
  struct Box
  {
    Vector3 corner;              // of lowest coordinates [m]; y = 0 with a mirror plane
    double edge;                 // of the largest cubes [m]
    std::array<int, 3> n;        // largest cubes along x, y, z
    bool mirror_y;               // symmetry plane at the corner's y
    std::vector<Region> regions; // to refine
    /// Cost of a cube with this centre and edge, relative to others, by which cubes are shared
    /// among the ranks; empty: all cost the same.
    std::function<unsigned int(const Vector3 &, double)> cost = {};
  };
  /// A cube of this rank.
  struct Element
  {
    std::array<int, 8> nodes; // local numbers of the corners x + 2 y + 4 z, or of their copies
    double edge;              // [m]
  };
  /// What is added up at the nodes where elements of several ranks meet, in the order in which one
  /// rank would have added it.
  struct SummationOrder
  {
    /// One of them, added after those before it.
    struct Term
    {
      int node;   // owned
      int source; // a copy, or from n_nodes() on: of other ranks', in the order they come in
    };
    std::vector<Term> terms; // of all such nodes
  };
  /// Node k of the list follows its masters: x = sum of weight * x of masters first[k] ...
  /// first[k + 1] - 1. Masters never hang themselves. Covers all hanging nodes of this rank's
  /// elements, owned or not.
  struct HangingNodes
  {
    std::vector<int> node;      // local number
    std::vector<int> first;     // one more entry than nodes
    std::vector<int> master;    // local number
    std::vector<double> weight; // 1/2 on edges, 1/4 on faces [-]
  };

  /// At most so many cubes may be in the coarsest layout, which every rank stores; edges that can
  /// all be halved together keep below it.
  static constexpr std::int64_t max_coarse_cells = 300000;

  /// Collective. Throws InputError for an empty box, a region that misses it or has no extent, more
  /// than max_coarse_cells (name of the remedy in the message), or fewer cubes than ranks.
  HexMesh(MPI_Comm communicator, const Box &box);
  ~HexMesh();

  const Box &box() const { return box_; }                                 // as given
  int n_owned_nodes() const { return n_owned_nodes_; }                    // of this rank
  int n_nodes() const { return static_cast<int>(reference_.size() / 3); } // with ghosts and copies
  std::int64_t n_global_nodes() const { return n_global_nodes_; }         // hanging ones included
  std::int64_t n_global_elements() const { return n_global_elements_; }   // of all ranks
  std::int64_t first_owned_node() const { return first_owned_node_; }     // its global number
  /// The global number of a local one.
  std::int64_t global_node(const int node) const
  {
    return node < n_owned_nodes_ ? first_owned_node_ + node : others_[node - n_owned_nodes_];
  }
  /// Of a local node [m].
  Vector3 reference_position(const int node) const
  {
    return {reference_[3 * node], reference_[3 * node + 1], reference_[3 * node + 2]};
  }
  const std::vector<double> &reference() const { return reference_; } // [3 * n_nodes()] [m]
  /// Of this rank, in an order that all ranks together have.
  const std::vector<Element> &elements() const { return elements_; }
  /// In the reference configuration [m].
  Vector3 centre(const Element &element) const
  {
    return reference_position(element.nodes[0]) + Vector3::Constant(0.5 * element.edge);
  }
  /// A number for a place of the reference configuration where a node or the centre of a cube may
  /// be, the same on any number of ranks.
  std::int64_t place_number(const Vector3 &place) const;
  const HangingNodes &hanging_nodes() const { return hanging_; } // of this rank's elements
  /// Whether a node lies on the symmetry plane, where u_y = 0.
  bool on_mirror_plane(const int node) const
  {
    return box_.mirror_y && reference_[3 * node + 1] == box_.corner.y();
  }

  /// Takes owned values to the ranks that have them as ghosts, and to all copies. `values` has
  /// 3 * n_nodes() entries. Collective.
  void update_ghosts(double *values) const;
  /// Hanging nodes take the weighted values of their masters, which must be up to date.
  void follow_masters(double *values) const;
  /// The transpose of both, for what elements have added at their nodes, once each: what is in
  /// copies goes to the nodes' owners, and what hanging nodes have then to their masters. Hanging
  /// nodes, ghosts and copies are zero then; what was in ghosts themselves is lost. The same bits
  /// on any number of ranks, if elements have added in their order. Collective.
  void add_to_owners(double *values) const;
  /// The same for elements that have added in the order that was asked for.
  void add_to_owners(double *values, const SummationOrder &order) const;
  /// For what adds all elements of group 0 first, then those of group 1 and so on, each group in
  /// the order of the elements. `group` has an entry per element. Collective.
  SummationOrder summation_order(const std::vector<int> &group) const;

private:
  struct Exchange;

  std::int64_t order_number(const Element &element) const;
  void copy_shared_nodes(MPI_Comm communicator, const std::vector<std::int64_t> &ends);

  Box box_;
  double finest_               = 0.; // edge of the smallest cubes of all ranks [m]
  int n_owned_nodes_           = 0;
  std::int64_t n_global_nodes_ = 0, n_global_elements_ = 0, first_owned_node_ = 0;
  std::vector<double> reference_;
  std::vector<std::int64_t> others_; // global numbers of ghosts, and of what the copies are of
  std::vector<Element> elements_;
  HangingNodes hanging_;
  std::unique_ptr<Exchange> exchange_;
};
} // namespace ricochet
