// SPDX-License-Identifier: LGPL-2.1-or-later
// The one way in which the program warns of results that are not what the user may take them for.
#pragma once

#include <mpi.h>
#include <string>

namespace ricochet
{
/// "warning: ..." on standard error, from rank 0 alone; a line of progress above it stays whole.
void warn(MPI_Comm communicator, const std::string &text);
} // namespace ricochet
