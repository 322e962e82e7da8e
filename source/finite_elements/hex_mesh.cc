// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/hex_mesh.h"

#include "ricochet/base/exceptions.h"

#include <deal.II/base/partitioner.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace ricochet
{
namespace
{
using Triangulation = dealii::parallel::distributed::Triangulation<3>;

void check(const HexMesh::Box &box)
{
  if (box.edge <= 0. || *std::min_element(box.n.begin(), box.n.end()) < 1)
  {
    std::ostringstream message;
    message << "A mesh of " << box.n[0] << " x " << box.n[1] << " x " << box.n[2]
            << " cubes of edge " << 1e3 * box.edge
            << " mm is empty; choose a positive edge and at least one cube along each axis.";
    throw InputError(message.str());
  }
  const Vector3 high = box.corner + box.edge * Vector3(box.n[0], box.n[1], box.n[2]);
  for (const auto &region : box.regions)
    if (region.levels < 1 || (region.low.array() >= region.high.array()).any() ||
        (region.low.array() >= high.array()).any() ||
        (region.high.array() <= box.corner.array()).any())
    {
      std::ostringstream message;
      message << "The refinement region from (" << 1e3 * region.low.transpose() << ") mm to ("
              << 1e3 * region.high.transpose() << ") mm with " << region.levels
              << " levels refines nothing; it must overlap the mesh from ("
              << 1e3 * box.corner.transpose() << ") mm to (" << 1e3 * high.transpose()
              << ") mm, have an extent along each axis and at least one level.";
      throw InputError(message.str());
    }
}

/// How often all three counts can be halved: these levels are left to the tree of cells, because
/// every rank stores all roots of the forest but only its share of the trees.
int n_common_halvings(std::array<int, 3> n)
{
  int halvings = 0;
  while (n[0] % 2 == 0 && n[1] % 2 == 0 && n[2] % 2 == 0)
  {
    for (int &count : n)
      count /= 2;
    ++halvings;
  }
  return halvings;
}

/// Levels below box.edge that the regions ask of a cube.
int levels_wanted(const HexMesh::Box &box, const Vector3 &low, const double edge)
{
  int levels          = 0;
  // Touching is not overlapping: a region drawn on the cubes' faces must not catch their neighbours
  // by rounding.
  const double margin = 1e-6 * edge;
  for (const auto &region : box.regions)
    if ((low.array() < region.high.array() - margin).all() &&
        (low.array() + edge > region.low.array() + margin).all())
      levels = std::max(levels, region.levels);
  return levels;
}

Vector3 as_vector(const dealii::Point<3> &p)
{
  return {p[0], p[1], p[2]};
}

void create_cells(Triangulation &triangulation, const HexMesh::Box &box, const int halvings)
{
  std::vector<unsigned int> roots(3);
  std::int64_t n_roots = 1;
  for (int d = 0; d < 3; ++d)
    n_roots *= roots[d] = static_cast<unsigned int>(box.n[d] >> halvings);
  if (n_roots > HexMesh::max_coarse_cells)
  {
    std::ostringstream message;
    message << "The mesh of " << box.n[0] << " x " << box.n[1] << " x " << box.n[2] << " cubes has "
            << n_roots << " roots, more than " << HexMesh::max_coarse_cells
            << "; choose counts along x, y and z that can all be halved more often (multiples of "
            << (2 << halvings) << ").";
    throw InputError(message.str());
  }
  dealii::Point<3> low, high;
  for (int d = 0; d < 3; ++d)
  {
    low[d]  = box.corner[d];
    high[d] = box.corner[d] + box.n[d] * box.edge;
  }
  dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, roots, low, high);
  triangulation.refine_global(halvings);
  for (;;)
  {
    unsigned int n_flagged = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const int below   = cell->level() - halvings;
        const double edge = std::ldexp(box.edge, -below);
        if (below < levels_wanted(box, as_vector(cell->vertex(0)), edge))
        {
          cell->set_refine_flag();
          ++n_flagged;
        }
      }
    if (dealii::Utilities::MPI::sum(n_flagged, triangulation.get_communicator()) == 0)
      return;
    triangulation.execute_coarsening_and_refinement();
  }
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
  check(box);
  const int halvings = n_common_halvings(box.n);
  Triangulation triangulation(communicator);
  create_cells(triangulation, box, halvings);
  if (box.cost && dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
  {
    triangulation.signals.weight.connect(
        [&](const Triangulation::cell_iterator &cell, const Triangulation::CellStatus)
        {
          const double edge = std::ldexp(box.edge, halvings - cell->level());
          return box.cost(as_vector(cell->vertex(0)) + Vector3::Constant(0.5 * edge), edge);
        });
    triangulation.repartition();
  }
  n_global_elements_ = static_cast<std::int64_t>(triangulation.n_global_active_cells());
  if (const int n_ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
      n_global_elements_ < n_ranks)
    throw InputError("A mesh of " + std::to_string(n_global_elements_) +
                     " elements cannot be shared by " + std::to_string(n_ranks) +
                     " ranks; use fewer ranks or smaller elements.");

  dealii::DoFHandler<3> numbering(triangulation);
  numbering.distribute_dofs(dealii::FE_Q<3>(1)); // one number per vertex
  const dealii::IndexSet owned = numbering.locally_owned_dofs();
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(numbering, relevant);
  dealii::AffineConstraints<double> constraints(relevant);
  dealii::DoFTools::make_hanging_node_constraints(numbering, constraints);
  constraints.close();

  // Ghosts: nodes of this rank's elements that others own, and masters of those that hang.
  using Index = dealii::types::global_dof_index;
  std::vector<Index> corner(8), needed, hanging;
  for (const auto &cell : numbering.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(corner);
      for (const Index node : corner)
      {
        needed.push_back(node);
        if (const auto *masters = constraints.get_constraint_entries(node))
        {
          hanging.push_back(node);
          for (const auto &entry : *masters)
            needed.push_back(entry.first);
        }
      }
    }
  const auto make_unique = [](std::vector<Index> &list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  make_unique(needed);
  make_unique(hanging);
  dealii::IndexSet ghosts(owned.size());
  ghosts.add_indices(needed.begin(), needed.end());
  ghosts.subtract_set(owned);
  ghosts.compress();

  for (const auto ghost : ghosts)
    ghosts_.push_back(static_cast<std::int64_t>(ghost));
  n_global_nodes_   = static_cast<std::int64_t>(owned.size());
  n_owned_nodes_    = static_cast<int>(owned.n_elements());
  first_owned_node_ = n_owned_nodes_ > 0 ? static_cast<std::int64_t>(owned.nth_index_in_set(0)) : 0;
  const auto local  = [&](const Index node)
  {
    return owned.is_element(node)
               ? static_cast<int>(owned.index_within_set(node))
               : n_owned_nodes_ + static_cast<int>(ghosts.index_within_set(node));
  };

  // Vertices lie on the grid of the finest cubes; taken from there, a node has the same position on
  // every rank and edges are free of the rounding of repeated bisection.
  reference_.assign(3 * (n_owned_nodes_ + ghosts.n_elements()),
                    std::numeric_limits<double>::signaling_NaN());
  const double finest =
      std::ldexp(box.edge, halvings - static_cast<int>(triangulation.n_global_levels()) + 1);
  // Masters of ghosts may be corners of other ranks' cells only.
  for (const auto &cell : numbering.active_cell_iterators())
    if (!cell->is_artificial())
    {
      cell->get_dof_indices(corner);
      for (int v = 0; v < 8; ++v)
        if (owned.is_element(corner[v]) || ghosts.is_element(corner[v]))
          for (int d = 0; d < 3; ++d)
            reference_[3 * local(corner[v]) + d] =
                box.corner[d] + finest * std::round((cell->vertex(v)[d] - box.corner[d]) / finest);
      if (cell->is_locally_owned())
      {
        Element element;
        element.edge = std::ldexp(box.edge, halvings - cell->level());
        for (int v = 0; v < 8; ++v)
          element.nodes[v] = local(corner[v]);
        elements_.push_back(element);
      }
    }

  hanging_.first.push_back(0);
  for (const Index node : hanging)
  {
    hanging_.node.push_back(local(node));
    for (const auto &entry : *constraints.get_constraint_entries(node))
    {
      hanging_.master.push_back(local(entry.first));
      hanging_.weight.push_back(entry.second);
    }
    hanging_.first.push_back(static_cast<int>(hanging_.master.size()));
  }

  exchange_ = std::make_unique<Exchange>();
  exchange_->partitioner.reinit(three_per_node(owned), three_per_node(ghosts), communicator);
  exchange_->packed.resize(exchange_->partitioner.n_import_indices());
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
