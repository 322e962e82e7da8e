// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists from every rank to every rank.
#pragma once

#include "ricochet/base/mpi_tags.h"
#include "ricochet/base/vector.h"

#include <cstdint>
#include <limits>
#include <mpi.h>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ricochet
{
/// Entry r of the result is what rank r had in its entry for this rank. `lists` has one entry per
/// rank, of any length. Throws std::length_error, on the rank that asks for it alone, if a list
/// takes more than 2 GiB: messages count their bytes with an int. Collective.
template <class Item>
std::vector<std::vector<Item>> exchange_lists(const MPI_Comm communicator,
                                              const std::vector<std::vector<Item>> &lists)
{
  static_assert(std::is_trivially_copyable<Item>::value || std::is_same<Item, Vector3>::value,
                "sent as bytes");
  const std::size_t n_ranks = lists.size();
  std::vector<int> n_send(n_ranks), n_receive(n_ranks);
  for (std::size_t r = 0; r < n_ranks; ++r)
  {
    if (lists[r].size() * sizeof(Item) > std::size_t(std::numeric_limits<int>::max()))
      throw std::length_error("more than 2 GiB for one rank");
    n_send[r] = static_cast<int>(lists[r].size() * sizeof(Item));
  }
  MPI_Alltoall(n_send.data(), 1, MPI_INT, n_receive.data(), 1, MPI_INT, communicator);

  std::vector<std::vector<Item>> received(n_ranks);
  std::vector<MPI_Request> requests;
  for (std::size_t r = 0; r < n_ranks; ++r)
    if (n_receive[r] > 0)
    {
      received[r].resize(n_receive[r] / sizeof(Item));
      MPI_Irecv(received[r].data(), n_receive[r], MPI_BYTE, static_cast<int>(r), mpi_tag::lists,
                communicator, &requests.emplace_back());
    }
  for (std::size_t r = 0; r < n_ranks; ++r)
    if (n_send[r] > 0)
      MPI_Isend(lists[r].data(), n_send[r], MPI_BYTE, static_cast<int>(r), mpi_tag::lists,
                communicator, &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return received;
}

/// For each rank, the values with the given numbers: what exchange_lists() takes.
template <class Item>
std::vector<std::vector<Item>> chosen(const std::vector<Item> &values,
                                      const std::vector<std::vector<std::int32_t>> &numbers)
{
  std::vector<std::vector<Item>> selected(numbers.size());
  for (std::size_t r = 0; r < numbers.size(); ++r)
  {
    selected[r].reserve(numbers[r].size());
    for (const auto i : numbers[r])
      selected[r].push_back(values[i]);
  }
  return selected;
}

/// All lists behind one another, in the order of the ranks.
template <class Item>
std::vector<Item> joined(const std::vector<std::vector<Item>> &lists)
{
  std::vector<Item> all;
  for (const auto &list : lists)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}
} // namespace ricochet
