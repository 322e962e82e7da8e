// SPDX-License-Identifier: LGPL-2.1-or-later
#include "warning.h"

#include "ricochet/base/mpi_tools.h"

#include <iostream>

namespace ricochet
{
void warn(const MPI_Comm communicator, const std::string &text)
{
  if (rank_in(communicator) == 0)
    std::cerr << "\nwarning: " << text << "\n";
}
} // namespace ricochet
