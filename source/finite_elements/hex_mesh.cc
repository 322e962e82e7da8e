// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/hex_mesh.h"

#include "hex_cells.h"

#include <deal.II/base/partitioner.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ricochet
{
namespace
{
/// One number per vertex: which ones this rank owns, and which it needs of others.
class NodeNumbers
{
public:
  using Index = dealii::types::global_dof_index;

  explicit NodeNumbers(const Triangulation &triangulation) : handler_(triangulation)
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
  /// Nodes of this rank's elements that others own, and masters of those that hang.
  void find_ghosts()
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

  static void make_unique(std::vector<Index> &list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  dealii::DoFHandler<3> handler_;
  dealii::AffineConstraints<double> constraints_;
  dealii::IndexSet owned_, ghosts_;
  std::vector<Index> hanging_;
};

/// Vertices lie on the grid of the finest cubes; taken from there, a node has the same position on
/// every rank and edges are free of the rounding of repeated bisection.
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

HexMesh::HangingNodes hanging_nodes_of(const NodeNumbers &numbers)
{
  HexMesh::HangingNodes hanging;
  hanging.first.push_back(0);
  for (const auto node : numbers.hanging())
  {
    hanging.node.push_back(numbers.local(node));
    for (const auto &[master, weight] : numbers.masters(node))
    {
      hanging.master.push_back(numbers.local(master));
      hanging.weight.push_back(weight);
    }
    hanging.first.push_back(static_cast<int>(hanging.master.size()));
  }
  return hanging;
}

dealii::IndexSet three_per_node(const dealii::IndexSet &nodes)
{
  dealii::IndexSet components(3 * nodes.size());
  for (auto i = nodes.begin_intervals(); i != nodes.end_intervals(); ++i)
    components.add_range(3 * *i->begin(), 3 * (i->last() + 1));
  components.compress();
  return components;
}
} // namespace

struct HexMesh::Exchange
{
  dealii::Utilities::MPI::Partitioner partitioner;
  // Workspace of the exchange; a mesh is used by one thread.
  std::vector<double> packed;
  std::vector<MPI_Request> requests;

  dealii::ArrayView<double> owned(double *values) const
  {
    return {values, partitioner.locally_owned_size()};
  }
  dealii::ArrayView<double> ghosts(double *values) const
  {
    return {values + partitioner.locally_owned_size(), partitioner.n_ghost_indices()};
  }
};

HexMesh::~HexMesh() = default;

HexMesh::HexMesh(const MPI_Comm communicator, const Box &box) : box_(box)
{
  check_box(box);
  const int halvings = n_common_halvings(box.n);
  Triangulation triangulation(communicator);
  create_cells(triangulation, box, halvings);
  share_cells(triangulation, box, halvings);
  n_global_elements_ = checked_number_of_elements(triangulation);

  const NodeNumbers numbers(triangulation);
  const auto &owned = numbers.owned(), &ghosts = numbers.ghosts();
  for (const auto ghost : ghosts)
    ghosts_.push_back(static_cast<std::int64_t>(ghost));
  n_global_nodes_   = static_cast<std::int64_t>(owned.size());
  n_owned_nodes_    = static_cast<int>(owned.n_elements());
  first_owned_node_ = n_owned_nodes_ > 0 ? static_cast<std::int64_t>(owned.nth_index_in_set(0)) : 0;
  finest_ = std::ldexp(box.edge, halvings - static_cast<int>(triangulation.n_global_levels()) + 1);
  reference_ = reference_positions(numbers, box, finest_);
  elements_  = own_elements(numbers, box, halvings);
  hanging_   = hanging_nodes_of(numbers);

  exchange_ = std::make_unique<Exchange>();
  exchange_->partitioner.reinit(three_per_node(owned), three_per_node(ghosts), communicator);
  exchange_->packed.resize(exchange_->partitioner.n_import_indices());
}

std::int64_t HexMesh::place_number(const Vector3 &place) const
{
  std::int64_t number = 0;
  for (int d = 0; d < 3; ++d) // 2^20 steps along an axis are more than any mesh has
    number = (number << 21) + std::llround(2. * (place[d] - box_.corner[d]) / finest_);
  return number;
}

void HexMesh::update_ghosts(double *values) const
{
  auto &e = *exchange_;
  e.partitioner.export_to_ghosted_array_start<double, dealii::MemorySpace::Host>(
      0, e.owned(values), dealii::make_array_view(e.packed), e.ghosts(values), e.requests);
  e.partitioner.export_to_ghosted_array_finish<double, dealii::MemorySpace::Host>(e.ghosts(values),
                                                                                  e.requests);
}

void HexMesh::follow_masters(double *values) const
{
  for (std::size_t k = 0; k < hanging_.node.size(); ++k)
  {
    double *const own = values + 3 * hanging_.node[k];
    own[0] = own[1] = own[2] = 0.;
    for (int i = hanging_.first[k]; i < hanging_.first[k + 1]; ++i)
      for (int d = 0; d < 3; ++d)
        own[d] += hanging_.weight[i] * values[3 * hanging_.master[i] + d];
  }
}

void HexMesh::add_to_owners(double *values) const
{
  for (std::size_t k = 0; k < hanging_.node.size(); ++k)
  {
    double *const own = values + 3 * hanging_.node[k];
    for (int i = hanging_.first[k]; i < hanging_.first[k + 1]; ++i)
      for (int d = 0; d < 3; ++d)
        values[3 * hanging_.master[i] + d] += hanging_.weight[i] * own[d];
    own[0] = own[1] = own[2] = 0.;
  }
  auto &e = *exchange_;
  e.partitioner.import_from_ghosted_array_start<double, dealii::MemorySpace::Host>(
      dealii::VectorOperation::add, 0, e.ghosts(values), dealii::make_array_view(e.packed),
      e.requests);
  e.partitioner.import_from_ghosted_array_finish<double, dealii::MemorySpace::Host>(
      dealii::VectorOperation::add, dealii::make_array_view(std::as_const(e.packed)),
      e.owned(values), e.ghosts(values), e.requests);
}
} // namespace ricochet
