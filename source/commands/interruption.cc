// SPDX-License-Identifier: LGPL-2.1-or-later
#include "interruption.h"

#include <csignal>

namespace ricochet
{
namespace
{
volatile std::sig_atomic_t stop_requested = 0;

void request_stop(const int signal)
{
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}
} // namespace

Interruption::Interruption()
{
  stop_requested = 0;
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

Interruption::~Interruption()
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::requested(const MPI_Comm communicator) const
{
  int any = stop_requested;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, communicator);
  return any != 0;
}
} // namespace ricochet
