// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/interruption.h"

#include "support/scratch_directory.h"

#include <csignal>

namespace ricochet
{
namespace
{
using namespace tests;

TEST(Interruption, OfOneRankIsSeenByAll)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU})
  {
    const Interruption interruption;
    EXPECT_FALSE(interruption.requested(MPI_COMM_WORLD));
    if (rank() == n_ranks() - 1)
      std::raise(signal);
    EXPECT_TRUE(interruption.requested(MPI_COMM_WORLD));
    EXPECT_TRUE(interruption.requested(MPI_COMM_WORLD));
  }
  // The next run begins anew.
  EXPECT_FALSE(Interruption().requested(MPI_COMM_WORLD));
}

TEST(Interruption, AWishForACheckpointOfOneRankIsSeenByAllOnce)
{
  const Interruption interruption;
  EXPECT_FALSE(interruption.wishes(MPI_COMM_WORLD).checkpoint);
  if (rank() == n_ranks() - 1)
    std::raise(SIGUSR1);
  const auto wishes = interruption.wishes(MPI_COMM_WORLD);
  EXPECT_TRUE(wishes.checkpoint);
  EXPECT_FALSE(wishes.stop);
  EXPECT_FALSE(interruption.wishes(MPI_COMM_WORLD).checkpoint);
}

TEST(Interruption, LeavesTheSignalsAsTheyWereMeant)
{
  {
    const Interruption interruption;
    std::raise(SIGINT);
    // A second one would end the program.
    EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
  }
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
}

TEST(Interruption, DoesNotWakeWhatWasIgnored)
{
  std::signal(SIGHUP, SIG_IGN); // as nohup does
  {
    const Interruption interruption;
    std::raise(SIGHUP);
    EXPECT_FALSE(interruption.requested(MPI_COMM_WORLD));
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}
} // namespace
} // namespace ricochet
