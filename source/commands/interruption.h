// SPDX-License-Identifier: LGPL-2.1-or-later
// Signals as wishes that are met after the present step, instead of an end on the spot.
#pragma once

#include <mpi.h>

namespace ricochet
{
/// While it lives, SIGINT, SIGTERM, SIGHUP and SIGXCPU are wishes to stop, a second of which ends
/// the program at once, and SIGUSR1 one for a checkpoint. Also calls outlive_closed_files().
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

/// From now on that nobody reads the progress is no reason to end, and files that may not grow are
/// errors with a message: SIGPIPE and SIGXFSZ are ignored.
void outlive_closed_files();
} // namespace ricochet
