// SPDX-License-Identifier: LGPL-2.1-or-later
// What everybody asks of a communicator, in one line each.
#pragma once

#include <mpi.h>
#include <string>

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

/// Whether the statement is true on rank `root`, on every rank. Collective.
inline bool broadcast(const MPI_Comm communicator, const bool statement, const int root)
{
  int number = statement ? 1 : 0;
  MPI_Bcast(&number, 1, MPI_INT, root, communicator);
  return number != 0;
}
} // namespace ricochet
