// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_price.h"

#include "ricochet/base/mpi_tools.h"

#include <cmath>
#include <fstream>
#include <malloc.h>
#include <string>
#include <sys/resource.h>

namespace ricochet
{
namespace
{
/// The most of this process since forget_most_memory() [bytes].
double most_memory()
{
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("VmHWM:", 0) == 0)
      return 1024. * std::strtod(line.c_str() + 6, nullptr); // kB
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}
} // namespace

RunPrice price_of(const MPI_Comm communicator, const Simulation &simulation)
{
  RunPrice price{};
  price.steps        = std::ceil(simulation.scene().time.end_time / simulation.dt());
  price.bond_seconds = price.steps * simulation.time_step_info().seconds_per_step;
  // Debris contact and output: runs of prm/single_plate take 1.5 to 2.5 times their bond forces.
  price.seconds      = 2. * price.bond_seconds;
  price.core_seconds = price.seconds * size_of(communicator);
  price.memory       = most_memory();
  MPI_Allreduce(MPI_IN_PLACE, &price.memory, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return price;
}

void forget_most_memory()
{
  malloc_trim(0); // what has been given back counts no more
  std::ofstream("/proc/self/clear_refs") << "5";
}
} // namespace ricochet
