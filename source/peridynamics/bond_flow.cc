// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_flow.h"

#include "plane_exchange.h"
#include "ricochet/peridynamics/plane_archive.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ricochet
{
namespace
{
constexpr std::int64_t block_size = Lattice::block_size;

/// Where bonds of any point of block 0 are kept: in its own, and in those they come from.
std::vector<std::int64_t> blocks_that_reach(const std::vector<std::int64_t> &shifts)
{
  std::set<std::int64_t> blocks{0};
  for (const std::int64_t shift : shifts)
    for (std::int64_t lane = 0; lane < block_size; ++lane)
      blocks.insert(static_cast<std::int64_t>(
          std::floor(static_cast<double>(lane - shift) / static_cast<double>(block_size))));
  return {blocks.begin(), blocks.end()};
}
} // namespace

BondFlow::BondFlow(const Lattice &lattice, LatticeArrays &arrays, const FamilyConstants &family,
                   const FlowLaw &law, const double dt) :
  lattice_(lattice),
  family_(family), law_(law), dt_(dt),
  plastic_(lattice.size(), lattice.stencil().offsets.size(), 1, HistoryPrecision::single_precision),
  reaching_(blocks_that_reach(lattice.shifts())), flowed_(lattice.size() / block_size, 0),
  marked_(flowed_.size(), 0)
{
  for (auto *const field :
       {&strained_, &relaxing_, &mean_, &carrying_, &sum_, &square_, &dissipated_})
    field->assign(lattice.size(), 0.);
  point_at_fields(arrays);
}

void BondFlow::point_at_fields(LatticeArrays &arrays)
{
  arrays.plastic  = plastic_.singles();
  arrays.flowed   = flowed_.data();
  arrays.strained = strained_.data();
}

void BondFlow::begin(const LatticeState &state)
{
  state.zero(lattice_, strained_.data());
}

void BondFlow::mark(const std::ptrdiff_t point)
{
  const std::int64_t block = point / block_size, end = static_cast<std::int64_t>(marked_.size());
  if (marked_[block] == 2) // by another of its points
    return;
  for (const std::int64_t other : reaching_)
    if (block + other >= 0 && block + other < end && marked_[block + other] == 0)
      marked_[block + other] = 1;
  marked_[block] = 2;
}

/// All bonds of owned points that may yield, and all that flow: of ghosts and images too, whose
/// bonds with owned points this rank keeps as well.
void BondFlow::mark_blocks()
{
  std::fill(marked_.begin(), marked_.end(), 0);
  for (const auto &range : lattice_.existing_ranges())
    for (std::ptrdiff_t p = range.first * block_size; p < range.last * block_size; ++p)
      if (relaxing_[p] > 0. || (strained_[p] > 0. && lattice_.owned(p)))
        mark(p);
}

/// What of the ranges is marked; from now on it may have flowed.
std::vector<Lattice::BlockRange> BondFlow::marked(const std::vector<Lattice::BlockRange> &ranges)
{
  std::vector<Lattice::BlockRange> result;
  for (const auto &range : ranges)
    for (std::int64_t block = range.first; block < range.last; ++block)
    {
      if (marked_[block] == 0)
        continue;
      flowed_[block] = 1;
      if (result.empty() || result.back().last != block)
        result.push_back({block, block});
      ++result.back().last;
    }
  return result;
}

void BondFlow::step(const LatticeKernel &kernel, const BondTable &table, const LatticeState &state,
                    const BondBlocks &blocks, Halo &halo)
{
  mark_blocks();
  for (auto *const sum : {&carrying_, &sum_, &square_})
    state.zero(lattice_, sum->data());
  const FlowingBonds bonds{
      plastic_.singles(), relaxing_.data(), mean_.data(),       carrying_.data(),
      sum_.data(),        square_.data(),   dissipated_.data(), dt_};
  for (const auto &range : marked(blocks.whole))
    kernel.flow(state.arrays, table, bonds, range.first, range.last);
  for (const auto &range : marked(blocks.weighted))
    kernel.weighted_flow(state.arrays, table, bonds, range.first, range.last);
  find_shares(state, halo);
}

void BondFlow::find_shares(const LatticeState &state, Halo &halo)
{
  const double mu = family_.shear_modulus, V = family_.volume;
  const double *const half = state.arrays.half_weight;
  state.zero(lattice_, relaxing_.data());
  state.zero(lattice_, mean_.data());
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (carrying_[p] <= 0. || strained_[p] == 0. || (half != nullptr && half[p] < 0.5))
          return;
        const double theta  = sum_[p];
        mean_[p]            = theta / carrying_[p];
        const double energy = square_[p] / V - 5. * mu / 2. * theta * theta / carrying_[p]; // [Pa]
        const double tau    = std::sqrt(2. * mu * std::max(0., energy));
        relaxing_[p]        = 0.5 * relaxed_by_flow(law_, tau, -5. / 3. * mu * theta, mu, dt_);
      });
  halo.exchange({relaxing_.data(), mean_.data()});
  for (auto *const field : {&relaxing_, &mean_})
    state.mirror(lattice_, field->data());
}

double BondFlow::dissipated(const MPI_Comm communicator) const
{
  PlaneSums<1> sums(lattice_.box().n[0]);
  lattice_.for_each_owned([&](const std::ptrdiff_t p)
                          { sums[lattice_.plane_of(p)][0] += dissipated_[p]; });
  return sums.total(communicator)[0];
}

void BondFlow::redistribute(const PlaneExchange &planes, const std::ptrdiff_t size,
                            LatticeArrays &arrays)
{
  plastic_.redistribute(planes);
  planes.move(flowed_, 1. / block_size);
  for (auto *const field : {&relaxing_, &mean_, &dissipated_})
    planes.move(*field);
  for (auto *const field : {&strained_, &carrying_, &sum_, &square_})
    field->assign(size, 0.);
  marked_.assign(flowed_.size(), 0);
  point_at_fields(arrays);
}

void BondFlow::exchange_state(PlaneArchive &planes)
{
  plastic_.exchange_state(planes, "plastic extension");
  planes.field("flowed", flowed_.data(), 1. / block_size);
  planes.field("relaxing", relaxing_.data());
  planes.field("mean", mean_.data());
  planes.field("plastic dissipation", dissipated_.data());
}
} // namespace ricochet
