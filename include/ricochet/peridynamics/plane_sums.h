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

  /// Sum over planes and ranks. Collective.
  Values total(const MPI_Comm communicator) const
  {
    int n_ranks;
    MPI_Comm_size(communicator, &n_ranks);
    // A plane's row is zero on all ranks but its owner's, so this reduction is exact.
    const std::vector<Values> *all = &planes_;
    std::vector<Values> gathered;
    if (n_ranks > 1)
    {
      gathered = planes_;
      MPI_Allreduce(MPI_IN_PLACE, gathered.data(), static_cast<int>(gathered.size() * n_quantities),
                    MPI_DOUBLE, MPI_SUM, communicator);
      all = &gathered;
    }
    Values sum{};
    for (const auto &plane : *all)
      for (int i = 0; i < n_quantities; ++i)
        sum[i] += plane[i];
    return sum;
  }

private:
  std::vector<Values> planes_;
};
} // namespace ricochet
