// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/mpi_tools.h"

#include <gtest/gtest.h>

namespace ricochet
{
namespace
{
TEST(MpiTools, RanksAreNumberedFromZero)
{
  const int mine = rank_in(MPI_COMM_WORLD);
  int sum        = 0;
  MPI_Allreduce(&mine, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  const int n = size_of(MPI_COMM_WORLD);
  EXPECT_EQ(sum, n * (n - 1) / 2);
  EXPECT_EQ(rank_in(MPI_COMM_SELF), 0);
  EXPECT_EQ(size_of(MPI_COMM_SELF), 1);
}

TEST(MpiTools, TextReplacesWhatTheOthersHad)
{
  // The others' texts are shorter, longer and of bytes that end a text in C.
  const int n = size_of(MPI_COMM_WORLD);
  for (int root = 0; root < n; ++root)
    for (const std::string &wanted : {std::string("a few words"), std::string(),
                                      std::string("zero\0inside", 11), std::string(100000, 'x')})
    {
      const int mine = rank_in(MPI_COMM_WORLD);
      const std::string other(17 * mine, 'o');
      EXPECT_EQ(broadcast(MPI_COMM_WORLD, mine == root ? wanted : other, root), wanted);
    }
}

TEST(MpiTools, EveryRankGetsWhatAllHaveInTheirOrder)
{
  // Rank r has r things.
  const std::vector<double> mine(rank_in(MPI_COMM_WORLD), rank_in(MPI_COMM_WORLD));
  std::vector<double> expected;
  for (int r = 0; r < size_of(MPI_COMM_WORLD); ++r)
    expected.insert(expected.end(), r, r);
  EXPECT_EQ(gather_on_every_rank(MPI_COMM_WORLD, mine), expected);
}

TEST(MpiTools, TruthOfOneRankIsTheTruth)
{
  const int n = size_of(MPI_COMM_WORLD);
  for (int root = 0; root < n; ++root)
    for (const bool truth : {true, false})
      EXPECT_EQ(broadcast(MPI_COMM_WORLD, (rank_in(MPI_COMM_WORLD) == root) == truth, root), truth);
}
} // namespace
} // namespace ricochet
