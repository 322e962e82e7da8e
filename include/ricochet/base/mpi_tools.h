// SPDX-License-Identifier: LGPL-2.1-or-later
// What everybody asks of a communicator, in one line each.
#pragma once

#include <mpi.h>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace ricochet
{
/// Rank of this process, from 0.
inline int rank_in(const MPI_Comm communicator)
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

/// Number of ranks.
inline int size_of(const MPI_Comm communicator)
{
  int size = 1;
  MPI_Comm_size(communicator, &size);
  return size;
}

/// The text of rank `root`, on every rank; what the others pass is ignored. Any bytes, also none;
/// below 2 GiB. Collective.
inline std::string broadcast(const MPI_Comm communicator, std::string text, const int root)
{
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, root, communicator);
  text.resize(length);
  MPI_Bcast(text.data(), length, MPI_CHAR, root, communicator);
  return text;
}

/// What all ranks have, in their order, on every rank; below 2 GiB. Collective.
template <class T>
std::vector<T> gather_on_every_rank(const MPI_Comm communicator, const std::vector<T> &mine)
{
  static_assert(std::is_trivially_copyable_v<T>, "sent as bytes");
  const int n_ranks = size_of(communicator);
  if (n_ranks == 1)
    return mine;
  std::vector<int> counts(n_ranks), starts(n_ranks, 0);
  const int n = static_cast<int>(sizeof(T) * mine.size());
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<T> all((starts.back() + counts.back()) / sizeof(T));
  MPI_Allgatherv(mine.data(), n, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE,
                 communicator);
  return all;
}

/// Whether the statement is true on rank `root`, on every rank. Collective.
inline bool broadcast(const MPI_Comm communicator, const bool statement, const int root)
{
  int number = statement ? 1 : 0;
  MPI_Bcast(&number, 1, MPI_INT, root, communicator);
  return number != 0;
}
} // namespace ricochet
