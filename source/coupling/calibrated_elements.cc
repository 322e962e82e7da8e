// SPDX-License-Identifier: LGPL-2.1-or-later
#include "calibrated_elements.h"

#include "surface_layers.h"

#include "ricochet/base/exact_sum.h"
#include "ricochet/base/voigt.h"
#include "ricochet/coupling/slaved_points.h"

#include <algorithm>

namespace ricochet
{
namespace
{
// What softened points do can be mended in part only, and takes many iterations: at nodes that feel
// them forces may be so much larger.
constexpr double softened_factor = 5.;
} // namespace

CalibratedElements::CalibratedElements(const MPI_Comm communicator, const Lattice &lattice,
                                       const HexMesh &mesh, const double tolerance) :
  communicator_(communicator),
  lattice_(lattice), mesh_(mesh)
{
  MPI_Comm_size(communicator_, &n_ranks_);
  find_elements();
  number_nodes();
  for (const int node : nodes_)
  {
    const Vector3 X = mesh_.reference_position(node);
    allowed_.push_back((in_softened_layer(lattice_, X) ? softened_factor : 1.) * tolerance);
    role_.push_back(in_surface_layer(lattice_, X) ? NodeRole::surface
                    : mesh_.on_mirror_plane(node) ? NodeRole::mirror
                                                  : NodeRole::inside);
  }
}

void CalibratedElements::find_elements()
{
  for (std::size_t e = 0; e < mesh_.elements().size(); ++e)
  {
    const auto &element = mesh_.elements()[e];
    if (element.edge > 1.5 * edge())
      continue;
    const auto cell = cell_at(lattice_, mesh_.centre(element));
    if (zone().is_slaved(cell))
      elements_.push_back({static_cast<int>(e),
                           cell,
                           cell_pattern(zone(), cell, lattice_.stencil(), lattice_.box().mirror_y),
                           {}});
  }
}

/// Only nodes of these elements matter, those of other ranks' elements included.
void CalibratedElements::number_nodes()
{
  std::vector<double> touched(3 * static_cast<std::size_t>(mesh_.n_nodes()), 0.);
  for (const auto &element : elements_)
    for (const int node : mesh_.elements()[element.number].nodes)
      touched[3 * node] = 1.;
  if (n_ranks_ > 1)
  {
    auto owned = touched;
    mesh_.add_to_owners(owned.data());
    for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
      touched[3 * node] = owned[3 * node];
  }
  std::vector<int> number(mesh_.n_nodes(), -1);
  for (int node = 0; node < mesh_.n_nodes(); ++node)
    if (touched[3 * node] > 0.)
    {
      number[node] = static_cast<int>(nodes_.size());
      nodes_.push_back(node);
    }
  for (auto &element : elements_)
    for (int a = 0; a < 8; ++a)
      element.corner[a] = number[mesh_.elements()[element.number].nodes[a]];
}

void CalibratedElements::share(std::vector<char> &marked) const
{
  if (n_ranks_ == 1)
    return;
  std::vector<double> values(3 * static_cast<std::size_t>(mesh_.n_nodes()), 0.);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    values[3 * nodes_[i]] = marked[i];
  mesh_.add_to_owners(values.data());
  mesh_.update_ghosts(values.data());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    marked[i] = values[3 * nodes_[i]] > 0.;
}

void CalibratedElements::complete(NodalForces &forces) const
{
  if (n_ranks_ > 1)
  {
    std::vector<double> values(3 * static_cast<std::size_t>(mesh_.n_nodes()));
    for (int k = 0; k < n_unit_strains; ++k)
    {
      std::fill(values.begin(), values.end(), 0.);
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (int c = 0; c < 3; ++c)
          values[3 * nodes_[i] + c] = forces[i][c][k];
      mesh_.add_to_owners(values.data());
      mesh_.update_ghosts(values.data());
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (int c = 0; c < 3; ++c)
          forces[i][c][k] = values[3 * nodes_[i] + c];
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (role_[i] == NodeRole::surface)
      forces[i] = {StrainLanes::Zero(), StrainLanes::Zero(), StrainLanes::Zero()};
    else if (role_[i] == NodeRole::mirror)
      for (int k = 0; k < n_unit_strains; ++k)
      {
        const bool symmetric = k != voigt::number[1][2] && k != voigt::number[0][1];
        for (int c = 0; c < 3; ++c)
          if (symmetric == (c == 1))
            forces[i][c][k] = 0.;
      }
}

double CalibratedElements::squared_norm(const NodalForces &forces) const
{
  ExactSum sum;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i] < mesh_.n_owned_nodes())
      for (const auto &lanes : forces[i])
        sum.add(lanes.square().sum());
  return total(communicator_, sum);
}

double CalibratedElements::largest(const NodalForces &forces) const
{
  double most = 0.;
  for (const auto &force : forces)
    for (const auto &lanes : force)
      most = std::max(most, lanes.abs().maxCoeff());
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
  return most;
}

double CalibratedElements::largest_excess(const NodalForces &forces) const
{
  double most = 0.;
  for (std::size_t i = 0; i < forces.size(); ++i)
    for (const auto &lanes : forces[i])
      most = std::max(most, lanes.abs().maxCoeff() / allowed_[i]);
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, communicator_);
  return most;
}
} // namespace ricochet
