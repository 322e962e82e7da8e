// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/collective.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"

#include <string>

namespace ricochet
{
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

  const int n_ranks   = size_of(comm);
  const int candidate = failed ? rank_in(comm) : n_ranks;
  int speaker         = n_ranks;
  MPI_Allreduce(&candidate, &speaker, 1, MPI_INT, MPI_MIN, comm);
  if (speaker == n_ranks)
    return;

  throw FileError(broadcast(comm, message, speaker));
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
