// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/halo.h"

#include "ricochet/base/mpi_tags.h"

#include <algorithm>

namespace ricochet
{
Halo::Halo(const MPI_Comm communicator, const Lattice &lattice, const int body) :
  communicator_(communicator), tag_(mpi_tag::halo(body)),
  count_(lattice.stencil().reach * lattice.plane_stride()), owned_begin_(lattice.owned_begin()),
  owned_end_(lattice.owned_end())
{
  int rank, n_ranks;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &n_ranks);
  left_  = rank > 0 ? rank - 1 : MPI_PROC_NULL;
  right_ = rank + 1 < n_ranks ? rank + 1 : MPI_PROC_NULL;
}

void Halo::exchange(const std::initializer_list<double *> fields)
{
  if (left_ == MPI_PROC_NULL && right_ == MPI_PROC_NULL)
    return;
  const std::size_t total = count_ * fields.size();
  for (auto *buffer : {&send_left_, &send_right_, &receive_left_, &receive_right_})
    buffer->resize(total);

  MPI_Request requests[4];
  MPI_Irecv(receive_left_.data(), static_cast<int>(total), MPI_DOUBLE, left_, tag_, communicator_,
            &requests[0]);
  MPI_Irecv(receive_right_.data(), static_cast<int>(total), MPI_DOUBLE, right_, tag_ + 1,
            communicator_, &requests[1]);
  std::ptrdiff_t at = 0;
  for (const double *field : fields)
  {
    std::copy_n(field + owned_begin_, count_, send_left_.data() + at);
    std::copy_n(field + owned_end_ - count_, count_, send_right_.data() + at);
    at += count_;
  }
  MPI_Isend(send_left_.data(), static_cast<int>(total), MPI_DOUBLE, left_, tag_ + 1, communicator_,
            &requests[2]);
  MPI_Isend(send_right_.data(), static_cast<int>(total), MPI_DOUBLE, right_, tag_, communicator_,
            &requests[3]);
  MPI_Waitall(4, requests, MPI_STATUSES_IGNORE);

  at = 0;
  for (double *field : fields)
  {
    if (left_ != MPI_PROC_NULL)
      std::copy_n(receive_left_.data() + at, count_, field + owned_begin_ - count_);
    if (right_ != MPI_PROC_NULL)
      std::copy_n(receive_right_.data() + at, count_, field + owned_end_);
    at += count_;
  }
}
} // namespace ricochet
