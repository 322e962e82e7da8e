// SPDX-License-Identifier: LGPL-2.1-or-later
// A look ahead: which points have a bond near its limit. Nothing breaks.
#pragma once

#include "ricochet/peridynamics/bond_tables.h"
#include "ricochet/peridynamics/broken_bond_log.h"

#include <vector>

namespace ricochet
{
class StretchedPoints
{
public:
  explicit StretchedPoints(const Lattice &lattice) : log_(lattice.shifts()) {}

  /// Points of the blocks given from which an intact bond goes out that is stretched beyond
  /// `stretch` [-], each perhaps several times. `arrays` belong to a lattice with so many points,
  /// `size`, padding included; their bonds and theta stay as they are.
  std::vector<std::ptrdiff_t> find(const LatticeKernel &kernel, const BondTables &tables,
                                   const LatticeArrays &arrays, std::ptrdiff_t size, double stretch,
                                   const std::vector<Lattice::BlockRange> &blocks);

private:
  BrokenBondLog log_;
  std::vector<std::uint8_t> bonds_; // copies that the kernel may change
  std::vector<double> theta_;
};
} // namespace ricochet
