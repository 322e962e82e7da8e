// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/hex_mesh.h"

#include "node_numbers.h"
#include "shared_sums.h"

#include "ricochet/base/mpi_tools.h"

#include <deal.II/base/partitioner.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ricochet
{
namespace
{
dealii::IndexSet three_per_node(const dealii::IndexSet &nodes)
{
  dealii::IndexSet components(3 * nodes.size());
  for (auto i = nodes.begin_intervals(); i != nodes.end_intervals(); ++i)
    components.add_range(3 * *i->begin(), 3 * (i->last() + 1));
  components.compress();
  return components;
}

/// Where the ranks' ranges of nodes end.
std::vector<std::int64_t> owner_ends(const MPI_Comm communicator, const std::int64_t n_owned)
{
  auto ends = gather_on_every_rank(communicator, std::vector<std::int64_t>{n_owned});
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  return ends;
}
} // namespace

struct HexMesh::Exchange
{
  dealii::Utilities::MPI::Partitioner partitioner;
  NodeCopies copies;
  SummationOrder order; // of the elements
  HangingSums hanging;
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
  /// Owned nodes that other ranks know.
  std::vector<char> lent() const
  {
    std::vector<char> lent(partitioner.locally_owned_size() / 3, 0);
    for (const auto &[begin, end] : partitioner.import_indices())
      for (auto i = begin; i < end; ++i)
        lent[i / 3] = 1;
    return lent;
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
    others_.push_back(static_cast<std::int64_t>(ghost));
  n_global_nodes_   = static_cast<std::int64_t>(owned.size());
  n_owned_nodes_    = static_cast<int>(owned.n_elements());
  first_owned_node_ = n_owned_nodes_ > 0 ? static_cast<std::int64_t>(owned.nth_index_in_set(0)) : 0;
  finest_ = std::ldexp(box.edge, halvings - static_cast<int>(triangulation.n_global_levels()) + 1);
  reference_ = reference_positions(numbers, box, finest_);
  elements_  = own_elements(numbers, box, halvings);
  std::sort(elements_.begin(), elements_.end(),
            [&](const Element &a, const Element &b) { return order_number(a) < order_number(b); });
  hanging_ = hanging_nodes_of(numbers, reference_);

  exchange_ = std::make_unique<Exchange>();
  exchange_->partitioner.reinit(three_per_node(owned), three_per_node(ghosts), communicator);
  exchange_->packed.resize(exchange_->partitioner.n_import_indices());
  const auto ends    = owner_ends(communicator, n_owned_nodes_);
  exchange_->hanging = HangingSums(communicator, *this, ends);
  copy_shared_nodes(communicator, ends);
}

/// Corners of elements at nodes where other ranks' elements may be, too, become copies.
void HexMesh::copy_shared_nodes(const MPI_Comm communicator, const std::vector<std::int64_t> &ends)
{
  const auto lent   = exchange_->lent();
  const int n_local = n_nodes();
  std::vector<NodeCopies::Corner> corners;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int c = 0; c < 8; ++c)
    {
      const int node = elements_[e].nodes[c];
      if (node < n_owned_nodes_ && !lent[node])
        continue;
      const auto global = global_node(node);
      const auto rank   = std::upper_bound(ends.begin(), ends.end(), global) - ends.begin();
      corners.push_back({static_cast<int>(rank), global, order_number(elements_[e]),
                         static_cast<int>(e), c, node});
    }
  exchange_->copies = NodeCopies(communicator, std::move(corners), first_owned_node_, n_local);
  int copy          = n_local;
  for (const auto &corner : exchange_->copies.corners())
  {
    elements_[corner.element].nodes[corner.corner] = copy++;
    others_.push_back(corner.node);
    for (int d = 0; d < 3; ++d)
      reference_.push_back(reference_[3 * static_cast<std::size_t>(corner.local) + d]);
  }
  exchange_->order = summation_order({});
}

std::int64_t HexMesh::place_number(const Vector3 &place) const
{
  std::int64_t number = 0;
  for (int d = 0; d < 3; ++d) // 2^20 steps along an axis are more than any mesh has
    number = (number << 21) + std::llround(2. * (place[d] - box_.corner[d]) / finest_);
  return number;
}

/// Along Morton's curve, on which elements that share nodes are mostly close to each other.
std::int64_t HexMesh::order_number(const Element &element) const
{
  const std::int64_t place = place_number(centre(element));
  std::int64_t number      = 0;
  for (int bit = 20; bit >= 0; --bit)
    for (const int of_axis : {0, 21, 42}) // z, y, x
      number = number << 1 | ((place >> (of_axis + bit)) & 1);
  return number;
}

void HexMesh::update_ghosts(double *values) const
{
  auto &e = *exchange_;
  e.partitioner.export_to_ghosted_array_start<double, dealii::MemorySpace::Host>(
      0, e.owned(values), dealii::make_array_view(e.packed), e.ghosts(values), e.requests);
  e.partitioner.export_to_ghosted_array_finish<double, dealii::MemorySpace::Host>(e.ghosts(values),
                                                                                  e.requests);
  e.copies.take_values(values);
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
  exchange_->copies.take_values(values);
}

void HexMesh::add_to_owners(double *values) const
{
  add_to_owners(values, exchange_->order);
}

void HexMesh::add_to_owners(double *values, const SummationOrder &order) const
{
  exchange_->copies.add_up(values, order);
  std::fill(values + 3 * std::ptrdiff_t(n_owned_nodes_), values + reference_.size(), 0.);
  exchange_->hanging.hand_on(values);
}

HexMesh::SummationOrder HexMesh::summation_order(const std::vector<int> &group) const
{
  return exchange_->copies.order(group);
}
} // namespace ricochet
