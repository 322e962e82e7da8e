// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/collective.h"

#include "ricochet/base/exceptions.h"

#include <string>

namespace ricochet
{
int rank_in(const MPI_Comm comm)
{
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

void on_every_rank(const MPI_Comm comm, const std::function<void()> &action)
{
  bool failed = false;
  std::string message;
  try
  {
    action();
  }
  catch (const std::exception &error)
  {
    failed  = true;
    message = error.what();
  }

  int n_ranks = 1;
  MPI_Comm_size(comm, &n_ranks);
  const int candidate = failed ? rank_in(comm) : n_ranks;
  int speaker         = n_ranks;
  MPI_Allreduce(&candidate, &speaker, 1, MPI_INT, MPI_MIN, comm);
  if (speaker == n_ranks)
    return;

  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, speaker, comm);
  message.resize(length);
  MPI_Bcast(message.data(), length, MPI_CHAR, speaker, comm);
  throw FileError(message);
}

void on_first_rank(const MPI_Comm comm, const std::function<void()> &action)
{
  on_every_rank(comm,
                [&]
                {
                  if (rank_in(comm) == 0)
                    action();
                });
}
} // namespace ricochet
