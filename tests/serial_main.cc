// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs tests on one rank without mpirun.
#include <gtest/gtest.h>

#include <cstdlib>
#include <mpi.h>

int main(int argc, char **argv)
{
  // One process talks to nobody: without a launcher daemon and network modules MPI starts in 0.03 s
  // instead of 0.3 s.
  for (const auto &[name, value] :
       {std::pair<const char *, const char *>{"ess_singleton_isolated", "1"},
        {"pml", "ob1"},
        {"btl", "self"},
        {"mtl", "^ofi"},
        {"osc", "^ucx"}})
    setenv(("OMPI_MCA_" + std::string(name)).c_str(), value, /*overwrite=*/0);
  testing::InitGoogleTest(&argc, argv);
  MPI_Init(&argc, &argv);
  const int result = RUN_ALL_TESTS();
  MPI_Finalize();
  return result;
}
