// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_blocks.h"

#include <gtest/gtest.h>

#include <vector>

namespace ricochet::tests
{
namespace
{
std::vector<int> times_visited(const std::vector<Lattice::BlockRange> &ranges,
                               const std::ptrdiff_t n_blocks)
{
  std::vector<int> times(n_blocks, 0);
  for (const auto &range : ranges)
    for (std::int64_t block = range.first; block < range.last; ++block)
      ++times[block];
  return times;
}

Lattice lattice(const Lattice::Mask &mask = {})
{
  return Lattice({Vector3::Zero(), 1e-3, {12, 40, 9}, false},
                 make_stencil(1e-3, 3., InfluenceFunction::cone), 0, 1, mask);
}

TEST(BondBlocks, WithoutWeightsEveryBlockWithAPointIsWhole)
{
  const auto l        = lattice([](const int x, const int y, int) { return x < 4 || y > 20; });
  const auto blocks   = find_bond_blocks(l, l.intact_bonds(), nullptr);
  const auto n_blocks = l.size() / Lattice::block_size;
  EXPECT_TRUE(blocks.weighted.empty());
  const auto all   = times_visited(blocks.all, n_blocks),
             whole = times_visited(blocks.whole, n_blocks);
  int n_empty      = 0;
  for (std::ptrdiff_t block = 0; block < n_blocks; ++block)
  {
    bool has_point = false;
    for (int lane = 0; lane < Lattice::block_size; ++lane)
      has_point = has_point || l.exists(block * Lattice::block_size + lane);
    ASSERT_EQ(all[block], has_point);
    ASSERT_EQ(whole[block], has_point);
    n_empty += !has_point;
  }
  EXPECT_GT(n_empty, 0);
}

TEST(BondBlocks, LightPointNeedsWeightsWhereverABondReachesIt)
{
  const auto l        = lattice();
  const auto bonds    = l.intact_bonds();
  const auto shifts   = l.shifts();
  const auto n_blocks = l.size() / Lattice::block_size;
  std::vector<double> half_weight(l.size(), 0.5);
  const auto light    = l.index(6, 20, 4);
  half_weight[light]  = 0.25;
  const auto blocks   = find_bond_blocks(l, bonds, half_weight.data());
  const auto whole    = times_visited(blocks.whole, n_blocks),
             weighted = times_visited(blocks.weighted, n_blocks),
             all      = times_visited(blocks.all, n_blocks);
  for (std::ptrdiff_t block = 0; block < n_blocks; ++block)
  {
    bool reaches = light / Lattice::block_size == block;
    for (std::size_t k = 0; k < shifts.size(); ++k)
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((bonds[block * shifts.size() + k] >> lane) & 1)
          reaches = reaches || block * Lattice::block_size + lane + shifts[k] == light;
    if (reaches)
    {
      EXPECT_EQ(weighted[block], 1) << block;
    }
    EXPECT_EQ(whole[block] + weighted[block], all[block]) << block;
  }
  EXPECT_GT(blocks.whole.size(), 0u);
  // Short runs between are not worth a kernel of their own.
  for (const auto &run : blocks.whole)
    EXPECT_GE(run.last - run.first, 16);
}
} // namespace
} // namespace ricochet::tests
