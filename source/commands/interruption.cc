// SPDX-License-Identifier: LGPL-2.1-or-later
#include "interruption.h"

#include <csignal>
#include <initializer_list>

namespace ricochet
{
namespace
{
// Ctrl-C, an end that somebody or a queue asks for, a terminal that closes, a limit of CPU time.
constexpr std::initializer_list<int> stops = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};

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

/// What the parent has had ignored stays so: nohup means it.
void handle(const int signal, void (*const handler)(int))
{
  if (std::signal(signal, handler) == SIG_IGN)
    std::signal(signal, SIG_IGN);
}
} // namespace

Interruption::Interruption()
{
  stop_requested = checkpoint_requested = 0;
  for (const int signal : stops)
    handle(signal, request_stop);
  std::signal(SIGUSR1, request_checkpoint);
  outlive_closed_files();
}

Interruption::~Interruption()
{
  for (const int signal : stops)
    handle(signal, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
}

void outlive_closed_files()
{
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal(signal, SIG_IGN);
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
