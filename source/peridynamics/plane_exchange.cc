// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plane_exchange.h"

#include "ricochet/base/mpi_tags.h"

#include <algorithm>

namespace ricochet
{
namespace
{
/// Global planes first <= x < last.
struct Planes
{
  int first, last;

  int n() const { return std::max(0, last - first); }
};

Planes common(const Planes &a, const Planes &b)
{
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}
} // namespace

void PlaneExchange::move_bytes(const char *const from, char *const to,
                               const double bytes_per_point) const
{
  int rank, n_ranks;
  MPI_Comm_rank(communicator_, &rank);
  MPI_Comm_size(communicator_, &n_ranks);
  const int reach = from_.stencil().reach;
  const std::size_t bytes =
      static_cast<std::size_t>(bytes_per_point * static_cast<double>(from_.plane_stride()));
  const auto owned_before = [&](const int r) {
    return Planes{from_.plane_starts()[r], from_.plane_starts()[r + 1]};
  };
  const auto needed = [&](const int r)
  {
    return common({to_.plane_starts()[r] - reach, to_.plane_starts()[r + 1] + reach},
                  {0, to_.box().n[0]});
  };
  const auto old_place = [&](const int plane)
  { return from + bytes * (plane - from_.first_plane() + reach); };
  const auto new_place = [&](const int plane)
  { return to + bytes * (plane - to_.first_plane() + reach); };
  // Counted in planes, as all of them together may be more bytes than an int can hold.
  MPI_Datatype plane;
  MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &plane);
  MPI_Type_commit(&plane);

  std::vector<MPI_Request> requests;
  for (int r = 0; r < n_ranks; ++r)
    if (const auto planes = common(owned_before(r), needed(rank)); planes.n() > 0 && r != rank)
      MPI_Irecv(new_place(planes.first), planes.n(), plane, r, mpi_tag::planes, communicator_,
                &requests.emplace_back());
  for (int r = 0; r < n_ranks; ++r)
    if (const auto planes = common(owned_before(rank), needed(r)); planes.n() > 0)
    {
      if (r == rank)
        std::copy_n(old_place(planes.first), bytes * planes.n(), new_place(planes.first));
      else
        MPI_Isend(old_place(planes.first), planes.n(), plane, r, mpi_tag::planes, communicator_,
                  &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  MPI_Type_free(&plane);
}
} // namespace ricochet
