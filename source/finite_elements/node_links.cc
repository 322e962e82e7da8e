// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/node_links.h"

#include "ricochet/base/exchange.h"
#include "ricochet/base/mpi_tags.h"

#include <algorithm>

namespace ricochet
{
NodeLinks::NodeLinks(const MPI_Comm communicator, const HexMesh &mesh,
                     const std::vector<std::int64_t> &nodes) :
  communicator_(communicator)
{
  int n_ranks;
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks);
  // Ranks own contiguous ranges in ascending order; an empty one starts where the next does.
  std::int64_t end = mesh.first_owned_node() + mesh.n_owned_nodes();
  if (mesh.n_owned_nodes() == 0)
    end = 0;
  std::vector<std::int64_t> ends(n_ranks);
  MPI_Allgather(&end, 1, MPI_INT64_T, ends.data(), 1, MPI_INT64_T, communicator);
  for (int r = 1; r < n_ranks; ++r)
    ends[r] = std::max(ends[r], ends[r - 1]);

  std::vector<std::vector<std::int64_t>> wanted(n_ranks);
  std::size_t at = 0;
  for (int r = 0; r < n_ranks; ++r)
  {
    const std::size_t first = at;
    while (at < nodes.size() && nodes[at] < ends[r])
      wanted[r].push_back(nodes[at++]);
    if (at > first)
      runs_.push_back({r, first, at});
  }
  const auto asked = exchange_lists(communicator, wanted);
  for (int r = 0; r < n_ranks; ++r)
  {
    std::vector<int> local;
    for (const auto node : asked[r])
      local.push_back(static_cast<int>(node - mesh.first_owned_node()));
    if (r == rank_)
      own_ = local;
    else if (!local.empty())
      lent_.push_back({r, local, std::vector<double>(3 * local.size()), {}});
  }
  number_sums();
}

void NodeLinks::number_sums()
{
  summed_ = own_;
  for (const auto &lent : lent_)
    summed_.insert(summed_.end(), lent.nodes.begin(), lent.nodes.end());
  std::sort(summed_.begin(), summed_.end());
  summed_.erase(std::unique(summed_.begin(), summed_.end()), summed_.end());
  sums_.resize(3 * summed_.size());
  const auto numbers_of = [&](const std::vector<int> &nodes)
  {
    std::vector<int> numbers;
    numbers.reserve(nodes.size());
    for (const int node : nodes)
      numbers.push_back(static_cast<int>(std::lower_bound(summed_.begin(), summed_.end(), node) -
                                         summed_.begin()));
    return numbers;
  };
  own_sums_ = numbers_of(own_);
  for (auto &lent : lent_)
    lent.sums = numbers_of(lent.nodes);
}

void NodeLinks::fetch(const std::vector<double> &values, std::vector<double> &seen)
{
  std::vector<MPI_Request> requests;
  for (const auto &run : runs_)
    if (run.rank != rank_)
      MPI_Irecv(seen.data() + 3 * run.first, static_cast<int>(3 * (run.last - run.first)),
                MPI_DOUBLE, run.rank, mpi_tag::node_values, communicator_,
                &requests.emplace_back());
  for (auto &lent : lent_)
  {
    for (std::size_t i = 0; i < lent.nodes.size(); ++i)
      std::copy_n(values.data() + 3 * lent.nodes[i], 3, lent.values.data() + 3 * i);
    MPI_Isend(lent.values.data(), static_cast<int>(lent.values.size()), MPI_DOUBLE, lent.rank,
              mpi_tag::node_values, communicator_, &requests.emplace_back());
  }
  for (const auto &run : runs_)
    if (run.rank == rank_)
      for (std::size_t i = run.first; i < run.last; ++i)
        std::copy_n(values.data() + 3 * own_[i - run.first], 3, seen.data() + 3 * i);
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

void NodeLinks::add(const std::vector<double> &seen, std::vector<double> &values)
{
  std::vector<MPI_Request> requests;
  std::fill(sums_.begin(), sums_.end(), 0.);
  for (auto &lent : lent_)
    MPI_Irecv(lent.values.data(), static_cast<int>(lent.values.size()), MPI_DOUBLE, lent.rank,
              mpi_tag::node_sums, communicator_, &requests.emplace_back());
  for (const auto &run : runs_)
    if (run.rank != rank_)
      MPI_Isend(seen.data() + 3 * run.first, static_cast<int>(3 * (run.last - run.first)),
                MPI_DOUBLE, run.rank, mpi_tag::node_sums, communicator_, &requests.emplace_back());
    else
      for (std::size_t i = run.first; i < run.last; ++i)
        for (int d = 0; d < 3; ++d)
          sums_[3 * own_sums_[i - run.first] + d] += seen[3 * i + d];
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (const auto &lent : lent_)
    for (std::size_t i = 0; i < lent.nodes.size(); ++i)
      for (int d = 0; d < 3; ++d)
        sums_[3 * lent.sums[i] + d] += lent.values[3 * i + d];
  for (std::size_t i = 0; i < summed_.size(); ++i)
    for (int d = 0; d < 3; ++d)
      values[3 * summed_[i] + d] += sums_[3 * i + d];
}
} // namespace ricochet
