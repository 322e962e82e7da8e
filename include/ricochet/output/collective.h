// SPDX-License-Identifier: LGPL-2.1-or-later
// Actions that may fail on one rank only, such as writing a file: the failure becomes known to all,
// so that every rank throws and the program ends cleanly instead of waiting for a rank that has
// gone.
#pragma once

#include <functional>
#include <mpi.h>

namespace ricochet
{
/// Runs the action on every rank. If it throws anywhere, all ranks throw FileError with the message
/// of the lowest rank that failed. Collective.
void on_every_rank(MPI_Comm comm, const std::function<void()> &action);

/// Runs the action on rank 0 only; if it throws, all ranks throw FileError with its message.
/// Collective.
void on_first_rank(MPI_Comm comm, const std::function<void()> &action);
} // namespace ricochet
