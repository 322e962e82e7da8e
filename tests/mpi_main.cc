// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the tests of one executable on any number of ranks: only rank 0 prints, and a failure on any
// rank fails all.
#include <gtest/gtest.h>
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
} // namespace

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
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
  MPI_Finalize();
  return result;
}
