// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/collective.h"

#include "support/scratch_directory.h"

namespace ricochet
{
namespace
{
using namespace tests;

TEST(Collective, FailureOfOneRankIsThrownOnAll)
{
  for (int failing = 0; failing < n_ranks(); ++failing)
  {
    int n_calls                = 0;
    const std::string expected = "disk of rank " + std::to_string(failing);
    const std::string message  = message_of(
        [&]
        {
          on_every_rank(MPI_COMM_WORLD,
                         [&]
                         {
                          ++n_calls;
                          if (rank() == failing)
                            throw FileError(expected);
                        });
        });
    EXPECT_EQ(message, expected);
    EXPECT_EQ(n_calls, 1);
  }
}

TEST(Collective, TheLowestRankSpeaksAndAnyExceptionBecomesAFileError)
{
  EXPECT_EQ(message_of(
                []
                {
                  on_every_rank(MPI_COMM_WORLD,
                                [] { throw std::runtime_error("rank " + std::to_string(rank())); });
                }),
            "rank 0");
}

TEST(Collective, OnFirstRankRunsNowhereElse)
{
  int n_calls = 0;
  on_first_rank(MPI_COMM_WORLD, [&] { ++n_calls; });
  EXPECT_EQ(n_calls, rank() == 0 ? 1 : 0);
  EXPECT_EQ(message_of([] { on_first_rank(MPI_COMM_WORLD, [] { throw FileError("full"); }); }),
            "full");
}
} // namespace
} // namespace ricochet
