// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums over all points which do not depend on the number of ranks, not even by rounding: each
// lattice plane, which lies on one rank, is summed by itself; the planes' sums are then added in
// their order.
#pragma once

#include <algorithm>
#include <array>
#include <mpi.h>
#include <vector>

namespace ricochet
{
template <int n_quantities>
class PlaneSums
{
public:
  /// What is summed.
  using Values = std::array<double, n_quantities>;

  /// All zero; `n_planes` of the whole body.
  explicit PlaneSums(const int n_planes) : planes_(n_planes, Values{}) {}

  /// Of a plane, by its global number.
  Values &operator[](const int plane) { return planes_[plane]; }
  /// Back to zero.
  void clear() { std::fill(planes_.begin(), planes_.end(), Values{}); }

  /// Rows of other planes than first <= plane < last become zero.
  void keep(const int first, const int last)
  {
    std::fill(planes_.begin(), planes_.begin() + first, Values{});
    std::fill(planes_.begin() + last, planes_.end(), Values{});
  }
  /// Planes have changed their owner, and what was summed goes with them: this rank has first <=
  /// plane < last now. Collective.
  void move_home(const MPI_Comm communicator, const int first, const int last)
  {
    add_ranks(communicator, planes_);
    keep(first, last);
  }

  /// Sum over planes and ranks. Collective.
  Values total(const MPI_Comm communicator) const
  {
    int n_ranks;
    MPI_Comm_size(communicator, &n_ranks);
    const std::vector<Values> *all = &planes_;
    std::vector<Values> gathered;
    if (n_ranks > 1)
    {
      gathered = planes_;
      add_ranks(communicator, gathered);
      all = &gathered;
    }
    Values sum{};
    for (const auto &plane : *all)
      for (int i = 0; i < n_quantities; ++i)
        sum[i] += plane[i];
    return sum;
  }

private:
  /// A plane's row is zero on all ranks but its owner's, so this reduction is exact.
  static void add_ranks(const MPI_Comm communicator, std::vector<Values> &planes)
  {
    MPI_Allreduce(MPI_IN_PLACE, planes.data(), static_cast<int>(planes.size() * n_quantities),
                  MPI_DOUBLE, MPI_SUM, communicator);
  }

  std::vector<Values> planes_;
};
} // namespace ricochet
