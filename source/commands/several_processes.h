// SPDX-License-Identifier: LGPL-2.1-or-later
// One command for what needs several processes: `ricochet bench search --processes 4` starts itself
// under mpirun.
#pragma once

#include <optional>

namespace ricochet
{
/// The rank that mpirun, or whatever else has started several processes, gives to this one, known
/// before MPI is initialised; nothing if it was started alone.
std::optional<int> launched_rank();

constexpr int most_processes = 1024; // more is a slip of the finger

/// If `n` > 1 and this process is not yet one of several, mpirun takes its place, with so many
/// processes of the same command line. Returns 0 if there is nothing to do, and an exit status,
/// having said why, if mpirun could not be started. Call before MPI is initialised.
int start_processes(int n, int argc, char **argv);
} // namespace ricochet
