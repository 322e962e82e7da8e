// SPDX-License-Identifier: LGPL-2.1-or-later
#include "node_numbers.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace ricochet
{
namespace
{
void make_unique(std::vector<NodeNumbers::Index> &list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}
} // namespace

NodeNumbers::NodeNumbers(const Triangulation &triangulation) : handler_(triangulation)
{
  handler_.distribute_dofs(dealii::FE_Q<3>(1));
  owned_ = handler_.locally_owned_dofs();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(handler_, relevant);
  constraints_.reinit(relevant);
  dealii::DoFTools::make_hanging_node_constraints(handler_, constraints_);
  constraints_.close();
  find_ghosts();
}

/// Nodes of this rank's elements that others own, and masters of those that hang.
void NodeNumbers::find_ghosts()
{
  std::vector<Index> corner(8), needed;
  for (const auto &cell : handler_.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(corner);
      for (const Index node : corner)
      {
        needed.push_back(node);
        if (!constraints_.is_constrained(node))
          continue;
        hanging_.push_back(node);
        for (const auto &entry : masters(node))
          needed.push_back(entry.first);
      }
    }
  make_unique(needed);
  make_unique(hanging_);
  ghosts_.set_size(owned_.size());
  ghosts_.add_indices(needed.begin(), needed.end());
  ghosts_.subtract_set(owned_);
  ghosts_.compress();
}

std::vector<double> reference_positions(const NodeNumbers &numbers, const HexMesh::Box &box,
                                        const double finest)
{
  std::vector<double> reference(3 * (numbers.owned().n_elements() + numbers.ghosts().n_elements()),
                                std::numeric_limits<double>::signaling_NaN());
  std::vector<NodeNumbers::Index> corner(8);
  // Masters of ghosts may be corners of other ranks' cells only.
  for (const auto &cell : numbers.handler().active_cell_iterators())
    if (!cell->is_artificial())
    {
      cell->get_dof_indices(corner);
      for (int v = 0; v < 8; ++v)
        if (numbers.is_known(corner[v]))
          for (int d = 0; d < 3; ++d)
            reference[3 * numbers.local(corner[v]) + d] =
                box.corner[d] + finest * std::round((cell->vertex(v)[d] - box.corner[d]) / finest);
    }
  return reference;
}

std::vector<HexMesh::Element> own_elements(const NodeNumbers &numbers, const HexMesh::Box &box,
                                           const int halvings)
{
  std::vector<HexMesh::Element> elements;
  std::vector<NodeNumbers::Index> corner(8);
  for (const auto &cell : numbers.handler().active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(corner);
      auto &element = elements.emplace_back();
      element.edge  = std::ldexp(box.edge, halvings - cell->level());
      for (int v = 0; v < 8; ++v)
        element.nodes[v] = numbers.local(corner[v]);
    }
  return elements;
}

HexMesh::HangingNodes hanging_nodes_of(const NodeNumbers &numbers,
                                       const std::vector<double> &reference)
{
  HexMesh::HangingNodes hanging;
  hanging.first.push_back(0);
  for (const auto node : numbers.hanging())
  {
    hanging.node.push_back(numbers.local(node));
    std::vector<std::pair<int, double>> masters;
    for (const auto &[master, weight] : numbers.masters(node))
      masters.emplace_back(numbers.local(master), weight);
    const auto place = [&](const int master)
    {
      const double *const X = reference.data() + 3 * std::ptrdiff_t(master);
      return std::make_tuple(X[0], X[1], X[2]);
    };
    std::sort(masters.begin(), masters.end(),
              [&](const auto &a, const auto &b) { return place(a.first) < place(b.first); });
    for (const auto &[master, weight] : masters)
    {
      hanging.master.push_back(master);
      hanging.weight.push_back(weight);
    }
    hanging.first.push_back(static_cast<int>(hanging.master.size()));
  }
  return hanging;
}
} // namespace ricochet
