// SPDX-License-Identifier: LGPL-2.1-or-later
// What changes a PeridynamicBody as a whole: a zone that grows, planes that move to other ranks, a
// state that is saved or restored.
#include "fracture_energy.h"
#include "plane_exchange.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/peridynamics/peridynamic_body.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <utility>

namespace ricochet
{
void PeridynamicBody::follow_zone(const int first, const int last)
{
  lattice_.follow_zone(first, last);
  state_.follow_zone(lattice_, first, last);
  auto appeared = damage_.follow_zone(first, last, state_);
  if (history_)
    new_bonds_ = std::move(appeared);
  find_blocks();
}

void PeridynamicBody::redistribute(const std::vector<int> &plane_starts)
{
  Lattice lattice(lattice_, plane_starts, rank_in(communicator_));
  LatticeState state(lattice, material_.cracks_push);
  const std::size_t n_bytes = lattice.size() / Lattice::block_size * tables_.breakable().n;
  std::vector<std::uint8_t> sound(state.arrays.bonds, state.arrays.bonds + n_bytes);
  const PlaneExchange planes(communicator_, lattice_, lattice);
  state.take_over(state_, planes, lattice);
  damage_.redistribute(planes, lattice, std::move(sound), *kernel_);
  if (history_)
    history_->redistribute(planes, lattice, communicator_);
  if (flow_)
    flow_->redistribute(planes, lattice.size(), state.arrays);

  lattice_ = std::move(lattice);
  state_   = std::move(state);
  halo_    = Halo(communicator_, lattice_, number_);
  fracture_->redistribute(communicator_);
  find_blocks();
}

void PeridynamicBody::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "points");
  PlaneArchive planes(archive, communicator_, lattice_);
  state_.exchange_state(planes, lattice_);
  damage_.exchange_state(planes);
  fracture_->exchange_state(planes);
  if (history_)
    history_->exchange_state(planes);
  if (flow_)
    flow_->exchange_state(planes);
}

void PeridynamicBody::continue_history(TensorFields &histories)
{
  for (auto &tensor : histories)
    for (int i = 0; i < 6; ++i)
    {
      halo_.exchange({tensor[i].data()});
      state_.mirror_component(lattice_, tensor[i].data(), i);
    }
  history_->take_over(state_.arrays, new_bonds_,
                      [&](const std::ptrdiff_t p, const int k)
                      {
                        const auto &t = histories[k];
                        Eigen::Matrix3d G;
                        G << t[0][p], t[5][p], t[4][p], t[5][p], t[1][p], t[3][p], t[4][p], t[3][p],
                            t[2][p];
                        return G;
                      });
  new_bonds_.clear();
}
} // namespace ricochet
