// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stretched_points.h"

#include <algorithm>

namespace ricochet
{
std::vector<std::ptrdiff_t> StretchedPoints::find(const LatticeKernel &kernel,
                                                  const BondTables &tables,
                                                  const LatticeArrays &arrays,
                                                  const std::ptrdiff_t size, const double stretch,
                                                  const std::vector<Lattice::BlockRange> &blocks)
{
  // The kernel breaks what is stretched in a copy; its log says what.
  auto constants = tables.breakable_constants();
  for (auto &c : constants)
    c.critical = stretch * c.length;
  BondTable table = tables.breakable();
  table.constants = constants.data();
  bonds_.resize(size / Lattice::block_size * table.n);
  theta_.resize(size);
  LatticeArrays copy = arrays;
  copy.bonds         = bonds_.data();
  copy.cracked       = nullptr;
  copy.strained      = nullptr;
  copy.theta         = theta_.data();

  std::vector<std::ptrdiff_t> points;
  for (const auto &range : blocks)
  {
    const std::int64_t first = range.first * table.n;
    std::copy_n(arrays.bonds + first, table.n * (range.last - range.first), copy.bonds + first);
    log_.make_room(kernel, range.last - range.first);
    log_.clear();
    log_.add(kernel, copy, table, range);
    log_.for_each([&](const std::ptrdiff_t p, std::ptrdiff_t, std::size_t)
                  { points.push_back(p); });
  }
  return points;
}
} // namespace ricochet
