// SPDX-License-Identifier: LGPL-2.1-or-later
// The blocks of points whose bonds a step has to visit. Kernels without weights are faster, hence
// those that need none are kept apart.
#pragma once

#include "ricochet/peridynamics/lattice.h"

#include <vector>

namespace ricochet
{
struct BondBlocks
{
  /// Of all points, in ranges of blocks.
  std::vector<Lattice::BlockRange> all;
  /// Those whose bonds all count in full, and the others.
  std::vector<Lattice::BlockRange> whole, weighted; // together all; every block is in one of them
};

/// Blocks up to the last owned plane that have a point other than those of contact alone.
/// `sound_bonds` as BondDamage::sound_bonds(). `half_weight`: half of each point's weight [-], or
/// null if all are whole; a block is whole if all its points and their neighbours are.
BondBlocks find_bond_blocks(const Lattice &lattice, const std::vector<std::uint8_t> &sound_bonds,
                            const double *half_weight);
} // namespace ricochet
