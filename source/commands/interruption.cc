// SPDX-License-Identifier: LGPL-2.1-or-later
#include "interruption.h"

#include <csignal>
#include <initializer_list>

namespace ricochet
{
namespace
{
volatile std::sig_atomic_t stop_requested = 0, checkpoint_requested = 0;

void request_stop(const int signal)
{
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

void request_checkpoint(int)
{
  checkpoint_requested = 1;
}
} // namespace

Interruption::Interruption()
{
  stop_requested = checkpoint_requested = 0;
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  std::signal(SIGUSR1, request_checkpoint);
}

Interruption::~Interruption()
{
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
    std::signal(signal, SIG_DFL);
}

Interruption::Wishes Interruption::wishes(const MPI_Comm communicator) const
{
  int any[] = {stop_requested, checkpoint_requested};
  if (any[1] != 0)
    checkpoint_requested = 0;
  MPI_Allreduce(MPI_IN_PLACE, any, 2, MPI_INT, MPI_MAX, communicator);
  return {any[0] != 0, any[1] != 0};
}
} // namespace ricochet
