// SPDX-License-Identifier: LGPL-2.1-or-later
// Signals as wishes that are met after the present step, instead of an end on the spot.
#pragma once

#include <mpi.h>

namespace ricochet
{
/// While it lives, SIGINT and SIGTERM are wishes to stop, a second of which ends the program at
/// once, and SIGUSR1 one for a checkpoint.
class Interruption
{
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption &)            = delete;
  Interruption &operator=(const Interruption &) = delete;

  struct Wishes
  {
    bool stop, checkpoint;
  };
  /// What any rank has been asked for; a checkpoint is asked for once. Collective.
  Wishes wishes(MPI_Comm communicator) const;
  /// Whether any rank has been asked to stop. Collective.
  bool requested(const MPI_Comm communicator) const { return wishes(communicator).stop; }
};
} // namespace ricochet
