// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/search/near_points.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ricochet
{
namespace
{
constexpr int bits = 21; // per axis of a cell's key

/// Number of a cell along an axis. What is further away than a million cells shares the last one.
std::int64_t cell_at(const double x, const double cell)
{
  constexpr double last = (1 << (bits - 1)) - 1;
  return static_cast<std::int64_t>(std::floor(std::min(std::max(x / cell, -last), last)));
}

/// Calls visit(key) for every coarse cell that the cube around a ball touches.
template <class Visitor>
void for_each_cell(const Vector3 &x, const double radius, const double cell, Visitor &&visit)
{
  if (!x.allFinite())
    return;
  std::int64_t first[3], last[3];
  for (int d = 0; d < 3; ++d)
  {
    first[d] = cell_at(x[d] - radius, cell);
    last[d]  = cell_at(x[d] + radius, cell);
  }
  constexpr std::int64_t offset = std::int64_t(1) << (bits - 1);
  for (std::int64_t i = first[0]; i <= last[0]; ++i)
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
      for (std::int64_t k = first[2]; k <= last[2]; ++k)
        visit(((i + offset) << (2 * bits)) | ((j + offset) << bits) | (k + offset));
}

/// Keys of cells, each once. Neighbouring points mostly repeat each other's cells: a small table of
/// recent keys keeps the list short before it is sorted.
class CellList
{
public:
  CellList() : recent_(1 << 12, -1) {}
  void add(const std::int64_t key)
  {
    auto &slot = recent_[(std::uint64_t(key) * 0x9e3779b97f4a7c15ull) >> 52];
    if (slot == key)
      return;
    slot = key;
    keys_.push_back(key);
  }
  std::vector<std::int64_t> sorted()
  {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    return std::move(keys_);
  }

private:
  std::vector<std::int64_t> recent_, keys_;
};
} // namespace

std::vector<std::vector<std::int32_t>> balls_near_other_ranks(const MPI_Comm communicator,
                                                              const std::vector<Vector3> &centres,
                                                              const std::vector<double> &radii,
                                                              const std::size_t n_asking,
                                                              const double cell)
{
  int rank, n_ranks;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &n_ranks);
  std::vector<std::vector<std::int32_t>> numbers(n_ranks);
  if (n_ranks == 1)
    return numbers;

  CellList asking;
  for (std::size_t i = 0; i < n_asking; ++i)
    for_each_cell(centres[i], radii[i], cell, [&](const std::int64_t key) { asking.add(key); });
  const std::vector<std::int64_t> own = asking.sorted();
  const int n_own                     = static_cast<int>(own.size());
  std::vector<int> n(n_ranks), begin(n_ranks + 1, 0);
  MPI_Allgather(&n_own, 1, MPI_INT, n.data(), 1, MPI_INT, communicator);
  for (int r = 0; r < n_ranks; ++r)
    begin[r + 1] = begin[r] + n[r];
  std::vector<std::int64_t> all(begin[n_ranks]);
  MPI_Allgatherv(own.data(), n_own, MPI_INT64_T, all.data(), n.data(), begin.data(), MPI_INT64_T,
                 communicator);

  // The others' cells which this rank has points in, with the ranks that ask for them.
  CellList touched;
  for (std::size_t i = 0; i < centres.size(); ++i)
    for_each_cell(centres[i], radii[i], cell, [&](const std::int64_t key) { touched.add(key); });
  const std::vector<std::int64_t> mine = touched.sorted();
  std::unordered_map<std::int64_t, std::vector<int>> asked;
  for (int r = 0; r < n_ranks; ++r)
    if (r != rank)
    {
      auto at = mine.begin(); // both lists ascend
      for (int i = begin[r]; i < begin[r + 1]; ++i)
      {
        while (at != mine.end() && *at < all[i])
          ++at;
        if (at != mine.end() && *at == all[i])
          asked[all[i]].push_back(r);
      }
    }
  if (asked.empty())
    return numbers;

  for (std::size_t i = 0; i < centres.size(); ++i)
    for_each_cell(centres[i], radii[i], cell,
                  [&](const std::int64_t key)
                  {
                    const auto ranks = asked.find(key);
                    if (ranks == asked.end())
                      return;
                    for (const int r : ranks->second)
                      if (numbers[r].empty() || numbers[r].back() != static_cast<std::int32_t>(i))
                        numbers[r].push_back(static_cast<std::int32_t>(i));
                  });
  return numbers;
}
} // namespace ricochet
