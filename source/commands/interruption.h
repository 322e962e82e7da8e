// SPDX-License-Identifier: LGPL-2.1-or-later
// Ctrl-C as a wish to stop after the present step instead of an end on the spot.
#pragma once

#include <mpi.h>

namespace ricochet
{
/// Catches SIGINT and SIGTERM while it lives; a second signal ends the program at once.
class Interruption
{
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption &)            = delete;
  Interruption &operator=(const Interruption &) = delete;

  /// Whether any rank has been asked to stop. Collective.
  bool requested(MPI_Comm communicator) const;
};
} // namespace ricochet
