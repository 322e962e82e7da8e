// SPDX-License-Identifier: LGPL-2.1-or-later
// How much state there is: what a checkpoint takes, without writing one.
#pragma once

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/state_archive.h"

namespace ricochet
{
/// Counts the bytes that it is shown.
class StateSize : public StateArchive
{
public:
  /// Of all ranks that share the state.
  explicit StateSize(const MPI_Comm communicator) : StateArchive(communicator) {}

  bool is_restoring() const override { return false; }

  /// Of all ranks. Collective.
  double bytes() const
  {
    double sum = own_;
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator());
    return sum;
  }

private:
  void add(const std::size_t n) { own_ += static_cast<double>(n); }

  void common_bytes(const std::string &, char *, const std::size_t n) override
  {
    add(rank_in(communicator()) == 0 ? n : 0);
  }
  std::size_t common_size(const std::string &) override { return 0; }
  void planes_bytes(const std::string &, char *, const std::size_t bytes_per_plane,
                    const PlaneShare &share) override
  {
    add(bytes_per_plane * static_cast<std::size_t>(share.last - share.first));
  }
  void rows_of(const std::string &, const std::vector<std::int64_t> &keys, std::vector<double> &,
               const std::size_t n_columns) override
  {
    add(keys.size() * sizeof(double) * (1 + n_columns));
  }

  double own_ = 0.;
};
} // namespace ricochet
