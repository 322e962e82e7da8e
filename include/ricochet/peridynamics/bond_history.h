// SPDX-License-Identifier: LGPL-2.1-or-later
// One number g per bond and Maxwell branch [m], see materials/maxwell_branch.h, in single or double
// precision. Laid out for kernels: [block of 8 points][offset][branch][point in its block].
#pragma once

#include "ricochet/materials/relaxation.h"
#include "ricochet/peridynamics/lattice.h"

#include <string>
#include <vector>

namespace ricochet
{
class PlaneArchive;
class PlaneExchange;

class BondHistory
{
public:
  /// All zero. `n_points`: entries of a field, padding included.
  BondHistory(std::ptrdiff_t n_points, std::size_t n_offsets, std::size_t n_branches,
              HistoryPrecision precision);

  /// The history of one bond in one branch.
  double read(const std::ptrdiff_t point, const std::size_t offset, const std::size_t branch) const
  {
    const std::size_t at = entry(point, offset, branch);
    return single_.empty() ? double_[at] : single_[at];
  }
  /// Sets it, rounded to the precision that is kept.
  void write(const std::ptrdiff_t point, const std::size_t offset, const std::size_t branch,
             const double value)
  {
    const std::size_t at = entry(point, offset, branch);
    if (single_.empty())
      double_[at] = value;
    else
      single_[at] = static_cast<float>(value);
  }

  /// All of it, or null if it is kept in the other precision.
  float *singles() { return single_.empty() ? nullptr : single_.data(); }
  /// Null if single precision is kept.
  double *doubles() { return double_.empty() ? nullptr : double_.data(); }
  /// 4 or 8.
  std::size_t bytes_per_bond_and_branch() const
  {
    return single_.empty() ? sizeof(double) : sizeof(float);
  }

  /// The lattice's planes are moving to other ranks: takes over what belongs to them. Collective.
  void redistribute(const PlaneExchange &planes);

  /// Saves or restores all of it. Collective.
  void exchange_state(PlaneArchive &planes, const std::string &name);

private:
  std::size_t entry(const std::ptrdiff_t point, const std::size_t offset,
                    const std::size_t branch) const
  {
    const std::size_t block = point / Lattice::block_size, lane = point % Lattice::block_size;
    return ((block * n_offsets_ + offset) * n_branches_ + branch) * Lattice::block_size + lane;
  }

  std::size_t n_offsets_, n_branches_;
  std::vector<float> single_;  // one of them
  std::vector<double> double_; // is empty
};
} // namespace ricochet
