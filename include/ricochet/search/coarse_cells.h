// SPDX-License-Identifier: LGPL-2.1-or-later
// Where in space something is, on any rank, at a glance.
#pragma once

#include "ricochet/base/vector.h"

#include <cmath>
#include <cstdint>
#include <mpi.h>
#include <vector>

namespace ricochet
{
/// Coarse cells of space, marked where something is. They repeat after 32 cells along each axis:
/// what is marked elsewhere too is looked at in vain, nothing is overlooked.
class CoarseCells
{
public:
  /// `size`: edge of a cell [m].
  explicit CoarseCells(const double size) : size_(size), marked_(period * period * period, 0) {}

  /// The cells within `margin` of x, along the axes [m].
  void mark(const Vector3 &x, const double margin)
  {
    const double low[3]  = {x[0] - margin, x[1] - margin, x[2] - margin},
                 high[3] = {x[0] + margin, x[1] + margin, x[2] + margin};
    for_each(low, high,
             [&](char &marked)
             {
               marked = 1;
               return false;
             });
  }
  /// Whether a cell of the box is marked; corners [m].
  bool any_marked(const double (&low)[3], const double (&high)[3])
  {
    return for_each(low, high, [](const char marked) { return marked != 0; });
  }
  /// What any rank has marked is marked on all. Collective.
  void join(const MPI_Comm communicator)
  {
    MPI_Allreduce(MPI_IN_PLACE, marked_.data(), static_cast<int>(marked_.size()), MPI_CHAR, MPI_MAX,
                  communicator);
  }

private:
  static constexpr int period = 32;

  /// Visits the cells of a box until visit() is true, and says whether it was. A box that is empty
  /// or not a number has none.
  template <class Visitor>
  bool for_each(const double (&low)[3], const double (&high)[3], Visitor &&visit)
  {
    std::int64_t first[3], n[3];
    for (int d = 0; d < 3; ++d)
    {
      const double from = std::floor(low[d] / size_), to = std::floor(high[d] / size_);
      if (!(to >= from))
        return false;
      n[d]     = to - from < period ? static_cast<std::int64_t>(to - from) + 1 : period;
      first[d] = std::abs(from) < 1e15 ? static_cast<std::int64_t>(from) : 0;
      if (std::abs(from) >= 1e15)
        n[d] = period;
    }
    for (std::int64_t i = 0; i < n[0]; ++i)
      for (std::int64_t j = 0; j < n[1]; ++j)
        for (std::int64_t k = 0; k < n[2]; ++k)
          if (visit(marked_[(
                  (((first[0] + i) & (period - 1)) * period + ((first[1] + j) & (period - 1))) *
                      period +
                  ((first[2] + k) & (period - 1)))]))
            return true;
    return false;
  }

  double size_; // [m]
  std::vector<char> marked_;
};
} // namespace ricochet
