// SPDX-License-Identifier: LGPL-2.1-or-later
// The vertices of a forest of cubes as nodes of a HexMesh: their numbers, places and masters.
#pragma once

#include "hex_cells.h"

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <utility>
#include <vector>

namespace ricochet
{
/// One number per vertex: which ones this rank owns, and which it needs of others.
class NodeNumbers
{
public:
  using Index = dealii::types::global_dof_index;

  explicit NodeNumbers(const Triangulation &triangulation);

  const dealii::DoFHandler<3> &handler() const { return handler_; }
  const dealii::IndexSet &owned() const { return owned_; }
  const dealii::IndexSet &ghosts() const { return ghosts_; }
  /// Of this rank's elements.
  const std::vector<Index> &hanging() const { return hanging_; }
  const std::vector<std::pair<Index, double>> &masters(const Index hanging) const
  {
    return *constraints_.get_constraint_entries(hanging);
  }
  bool is_known(const Index node) const
  {
    return owned_.is_element(node) || ghosts_.is_element(node);
  }
  /// Owned nodes first, then ghosts.
  int local(const Index node) const
  {
    return static_cast<int>(owned_.is_element(node)
                                ? owned_.index_within_set(node)
                                : owned_.n_elements() + ghosts_.index_within_set(node));
  }

private:
  void find_ghosts();

  dealii::DoFHandler<3> handler_;
  dealii::AffineConstraints<double> constraints_;
  dealii::IndexSet owned_, ghosts_;
  std::vector<Index> hanging_;
};

/// Vertices lie on the grid of the finest cubes; taken from there, a node has the same position on
/// every rank and edges are free of the rounding of repeated bisection.
std::vector<double> reference_positions(const NodeNumbers &numbers, const HexMesh::Box &box,
                                        double finest);

/// The cubes of this rank.
std::vector<HexMesh::Element> own_elements(const NodeNumbers &numbers, const HexMesh::Box &box,
                                           int halvings);

/// Masters in the order of their places, which is the same on any number of ranks.
HexMesh::HangingNodes hanging_nodes_of(const NodeNumbers &numbers,
                                       const std::vector<double> &reference);
} // namespace ricochet
