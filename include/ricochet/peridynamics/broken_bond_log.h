// SPDX-License-Identifier: LGPL-2.1-or-later
// The bonds that kernels have broken or let part, as they write them down: up to eight of one
// offset in an entry.
#pragma once

#include "ricochet/kernels/lattice_kernel.h"
#include "ricochet/peridynamics/lattice.h"

#include <utility>
#include <vector>

namespace ricochet
{
class BrokenBondLog
{
public:
  /// `shifts`: flat distance of the neighbours, per offset, see Lattice::shifts().
  explicit BrokenBondLog(std::vector<std::int64_t> shifts) : shifts_(std::move(shifts)) {}

  /// For all bonds of so many blocks of points to break at once by that kernel.
  void make_room(const LatticeKernel &kernel, const std::size_t n_blocks)
  {
    entries_.resize(kernel.registers_per_block * n_blocks * shifts_.size());
  }
  std::size_t capacity() const { return entries_.size(); } // [entries]
  std::size_t size() const { return size_; }               // [entries]
  /// Whether nothing has broken or parted.
  bool empty() const { return size_ == 0; }
  /// Forgets what has broken.
  void clear() { size_ = 0; }

  /// Lets the kernel break what is stretched beyond its limit in these blocks, and writes it down
  /// behind what is here.
  void add(const LatticeKernel &kernel, const LatticeArrays &arrays, const BondTable &table,
           const Lattice::BlockRange &blocks)
  {
    size_ += static_cast<std::size_t>(
        kernel.stretch(arrays, table, blocks.first, blocks.last, entries_.data() + size_));
  }

  /// Calls visit(p, q, k) for the bond k from point p to q of each that broke, in the order in
  /// which they were written down; a bond with ends on two ranks stands on both.
  template <class Visitor>
  void for_each(Visitor &&visit) const
  {
    for_each_of(&BrokenBonds::broken, visit);
  }
  /// The same for those that carry nothing from now on, now broken or earlier.
  template <class Visitor>
  void for_each_parted(Visitor &&visit) const
  {
    for_each_of(&BrokenBonds::parted, visit);
  }

private:
  template <class Visitor>
  void for_each_of(std::uint8_t BrokenBonds::*const which, Visitor &&visit) const
  {
    for (std::size_t i = 0; i < size_; ++i)
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((entries_[i].*which >> lane) & 1)
        {
          const std::ptrdiff_t p =
              static_cast<std::ptrdiff_t>(entries_[i].block) * Lattice::block_size + lane;
          visit(p, p + static_cast<std::ptrdiff_t>(shifts_[entries_[i].offset]),
                static_cast<std::size_t>(entries_[i].offset));
        }
  }

  std::vector<std::int64_t> shifts_;
  std::vector<BrokenBonds> entries_;
  std::size_t size_ = 0;
};
} // namespace ricochet
