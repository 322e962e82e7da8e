// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_blocks.h"

#include <utility>

namespace ricochet
{
namespace
{
using Masks = std::vector<std::uint8_t>; // per block

/// Rows are a few blocks long. To call one kernel for the start of a row and another for its end
/// costs more than weights that are 1.
void leave_short_runs(Masks &whole, Masks &weighted)
{
  constexpr std::int64_t least_run = 16;
  for (const auto &run : ranges_of_blocks(whole))
    if (run.last - run.first < least_run)
      for (std::int64_t block = run.first; block < run.last; ++block)
        std::swap(whole[block], weighted[block]);
}
} // namespace

BondBlocks find_bond_blocks(const Lattice &lattice, const std::vector<std::uint8_t> &sound_bonds,
                            const double *const half_weight)
{
  const auto shifts      = lattice.shifts();
  const std::size_t n    = shifts.size();
  const std::size_t last = lattice.owned_end() / Lattice::block_size;
  const auto has_weight  = [half_weight](const std::ptrdiff_t p)
  { return half_weight != nullptr && half_weight[p] != 0.5; };
  // Also points without bonds of their own in the forward half count: their dilatation has energy.
  Masks whole(last, 0), weighted(last, 0);
  for (std::size_t block = 0; block < last; ++block)
  {
    const std::ptrdiff_t first = block * Lattice::block_size;
    for (std::ptrdiff_t p = first; p < first + Lattice::block_size; ++p)
      if (lattice.exists(p) && lattice.kind(p) != PointKind::contact)
        (has_weight(p) ? weighted : whole)[block] = 1;
    for (std::size_t k = 0; k < n && half_weight != nullptr && !weighted[block]; ++k)
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((sound_bonds[block * n + k] >> lane) & 1 && has_weight(first + lane + shifts[k]))
          weighted[block] = 1;
    whole[block] &= !weighted[block];
  }
  if (half_weight != nullptr)
    leave_short_runs(whole, weighted);
  BondBlocks blocks;
  blocks.whole    = ranges_of_blocks(whole);
  blocks.weighted = ranges_of_blocks(weighted);
  for (std::size_t block = 0; block < last; ++block)
    whole[block] |= weighted[block];
  blocks.all = ranges_of_blocks(whole);
  return blocks;
}
} // namespace ricochet
