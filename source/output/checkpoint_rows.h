// SPDX-License-Identifier: LGPL-2.1-or-later
// What writer and reader of a checkpoint have in common: rows of bytes that ranks share, and their
// checksums.
#pragma once

#include "hdf5_handle.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <mpi.h>

namespace ricochet
{
constexpr const char *checksum_name = "checksum";

/// Of one row; which one it is counts too. FNV-1a (Fowler, Noll, Vo), eight bytes at a time.
inline std::uint64_t checksum_of(const char *const row, const std::size_t n_bytes,
                                 const std::size_t number)
{
  constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t sum             = (0xcbf29ce484222325 ^ number) * prime;
  for (std::size_t i = 0; i < n_bytes; i += sizeof(std::uint64_t))
  {
    std::uint64_t word = 0;
    std::memcpy(&word, row + i, std::min(sizeof(word), n_bytes - i));
    sum = (sum ^ word) * prime;
    sum ^= sum >> 29; // else the upper bits of a word never reach the lower ones of the sum
  }
  return sum;
}

/// Of several rows: ranks add up theirs.
inline std::uint64_t checksum_of(const char *const rows, const std::size_t bytes_per_row,
                                 const std::size_t first, const std::size_t n)
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += checksum_of(rows + i * bytes_per_row, bytes_per_row, first + i);
  return sum;
}

inline std::uint64_t sum_over_ranks(const MPI_Comm communicator, std::uint64_t sum)
{
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, communicator);
  return sum;
}

inline Handle file_access(const MPI_Comm communicator)
{
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create an access list");
  check(H5Pset_fapl_mpio(access, communicator, MPI_INFO_NULL), "select its parallel driver");
  return access;
}

inline Handle together()
{
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "create a transfer list");
  check(H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE), "choose collective access");
  return transfer;
}

/// Rows first <= row < first + n of a dataset's space, none if n is zero.
inline void select(const hid_t space, const std::size_t first, const std::size_t n,
                   const std::size_t bytes_per_row)
{
  const hsize_t start[2] = {first, 0}, count[2] = {n, bytes_per_row};
  check(n == 0 ? H5Sselect_none(space)
               : H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr),
        "select rows");
}

/// In memory, as many rows as are selected.
inline Handle memory_space(const std::size_t n, const std::size_t bytes_per_row)
{
  const hsize_t size[2] = {std::max<hsize_t>(n, 1), bytes_per_row};
  Handle space(H5Screate_simple(2, size, nullptr), H5Sclose, "create a shape");
  if (n == 0)
    check(H5Sselect_none(space), "select nothing");
  return space;
}
} // namespace ricochet
