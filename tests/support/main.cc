// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the tests of one executable on any number of ranks: only rank 0 prints, and a failure on any
// rank fails all.
#ifdef RICOCHET_TESTS_USE_DEALII
#include <deal.II/base/mpi.h>
#endif

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <mpi.h>

namespace
{
/// Rank 0 prints what happens; from the other ranks only failures are seen.
class FailurePrinter : public testing::EmptyTestEventListener
{
  void OnTestPartResult(const testing::TestPartResult &result) override
  {
    if (!result.failed())
      return;
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::cerr << "rank " << rank << ": " << (result.file_name() ? result.file_name() : "") << ':'
              << result.line_number() << ": " << result.summary() << std::endl;
  }
};

#ifdef RICOCHET_TESTS_USE_DEALII
using Mpi = dealii::Utilities::MPI::MPI_InitFinalize; // p4est wants its start-up
#else
struct Mpi
{
  Mpi(int &argc, char **&argv, int) { MPI_Init(&argc, &argv); }
  ~Mpi() { MPI_Finalize(); }
};
#endif

/// One process talks to nobody: without a launcher daemon and network modules MPI starts in 0.03 s
/// instead of 0.3 s.
void start_alone()
{
  for (const auto &[name, value] :
       {std::pair<const char *, const char *>{"ess_singleton_isolated", "1"},
        {"pml", "ob1"},
        {"btl", "self"},
        {"mtl", "^ofi"},
        {"osc", "^ucx"}})
    setenv(("OMPI_MCA_" + std::string(name)).c_str(), value, /*overwrite=*/0);
}
} // namespace

int main(int argc, char **argv)
{
  // What tests leave in a cache is no user's affair.
  setenv("XDG_CACHE_HOME", RICOCHET_BINARY_DIR "/tests/cache", /*overwrite=*/1);
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    start_alone();
  const Mpi mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank > 0)
  {
    testing::TestEventListeners &listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter);
  }

  const int mine = RUN_ALL_TESTS();
  int result     = 0;
  MPI_Allreduce(&mine, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return result;
}
