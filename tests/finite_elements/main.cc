// SPDX-License-Identifier: LGPL-2.1-or-later
// Like mpi_main.cc, with deal.II's start-up, which p4est needs: only rank 0 prints, and a failure
// on any rank fails all.
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <iostream>

namespace
{
/// Rank 0 prints what happens; from the other ranks only failures are seen.
class FailurePrinter : public testing::EmptyTestEventListener
{
  void OnTestPartResult(const testing::TestPartResult &result) override
  {
    if (result.failed())
      std::cerr << "rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ": "
                << (result.file_name() ? result.file_name() : "") << ':' << result.line_number()
                << ": " << result.summary() << std::endl;
  }
};
} // namespace

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
  {
    testing::TestEventListeners &listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter);
  }
  return dealii::Utilities::MPI::max(RUN_ALL_TESTS(), MPI_COMM_WORLD);
}
