// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exchange.h"
#include "ricochet/base/mpi_tools.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// What `from` sends to `to`: lists of different lengths, some of them empty.
std::vector<Vector3> letter(const int from, const int to)
{
  std::vector<Vector3> items;
  for (int i = 0; i < (2 * from + to) % 3; ++i)
    items.emplace_back(from, to, i);
  return items;
}

TEST(Exchange, EveryListArrivesWhereItBelongs)
{
  const int rank = rank_in(MPI_COMM_WORLD), n_ranks = size_of(MPI_COMM_WORLD);
  std::vector<std::vector<Vector3>> out;
  for (int to = 0; to < n_ranks; ++to)
    out.push_back(letter(rank, to));
  const auto in = exchange_lists(MPI_COMM_WORLD, out);
  ASSERT_EQ(static_cast<int>(in.size()), n_ranks);
  for (int from = 0; from < n_ranks; ++from)
    EXPECT_EQ(in[from], letter(from, rank)) << "from rank " << from;
}

TEST(Exchange, NothingAtAllIsFine)
{
  const std::vector<std::vector<char>> nothing(size_of(MPI_COMM_WORLD));
  EXPECT_EQ(exchange_lists(MPI_COMM_WORLD, nothing), nothing);
}

TEST(Exchange, ChosenAndJoinedKeepTheOrder)
{
  const std::vector<char> values{'a', 'b', 'c'};
  const auto lists = chosen(values, {{2, 0, 2}, {}, {1}});
  EXPECT_EQ(lists, (std::vector<std::vector<char>>{{'c', 'a', 'c'}, {}, {'b'}}));
  EXPECT_EQ(joined(lists), (std::vector<char>{'c', 'a', 'c', 'b'}));
}
} // namespace
} // namespace ricochet::tests
