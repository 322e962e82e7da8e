// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/search/hybrid_search.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace ricochet
{
namespace
{
/// Share of number `part` of the box, from 0 to n - 1.
int share(const double x, const double size, const int n)
{
  // Also for a box without extent and for what is not a number.
  const double part = x / size * n;
  return part >= n ? n - 1 : part > 0. ? static_cast<int>(part) : 0;
}
} // namespace

BlockGrid::BlockGrid(const MPI_Comm communicator, const std::vector<Vector3> &points)
{
  // The lowest corner and the negative of the highest one: one reduction.
  double corners[6];
  std::fill_n(corners, 6, std::numeric_limits<double>::max());
  for (const auto &x : points)
    if (x.allFinite())
      for (int d = 0; d < 3; ++d)
      {
        corners[d]     = std::min(corners[d], x[d]);
        corners[3 + d] = std::min(corners[3 + d], -x[d]);
      }
  MPI_Allreduce(MPI_IN_PLACE, corners, 6, MPI_DOUBLE, MPI_MIN, communicator);
  const Vector3 high(-corners[3], -corners[4], -corners[5]);
  low_  = Vector3(corners[0], corners[1], corners[2]);
  size_ = high - low_;

  int n_ranks, n[3] = {0, 0, 0};
  MPI_Comm_size(communicator, &n_ranks);
  MPI_Dims_create(n_ranks, 3, n); // in descending order
  // The longest side gets the most blocks.
  int axis[3] = {0, 1, 2};
  std::sort(axis, axis + 3, [&](const int a, const int b) { return size_[a] > size_[b]; });
  for (int i = 0; i < 3; ++i)
    n_[axis[i]] = n[i];
}

std::array<int, 3> BlockGrid::block_at(const Vector3 &x) const
{
  std::array<int, 3> block;
  for (int d = 0; d < 3; ++d)
    block[d] = share(x[d] - low_[d], size_[d], n_[d]);
  return block;
}

int BlockGrid::rank_at(const Vector3 &x) const
{
  const auto block = block_at(x);
  return rank_of(block[0], block[1], block[2]);
}

HybridSearch::HybridSearch(const MPI_Comm communicator, const std::string &method_inside) :
  communicator_(communicator), inside_(make_pair_search(method_inside))
{
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks_);
}

void HybridSearch::find(const std::vector<Vector3> &points, const std::vector<char> &active,
                        const std::vector<std::int64_t> &ids, const double radius)
{
  assert(ids.size() == points.size());
  const BlockGrid grid(communicator_, points);
  // Rounding must not part two points whose blocks are decided one by one.
  const double reach = radius * (1. + 1e-9);
  routes_.assign(n_ranks_, {});
  for (std::size_t i = 0; i < points.size(); ++i)
    grid.for_each_rank_near(points[i], reach,
                            [&](const int rank)
                            { routes_[rank].push_back(static_cast<std::int32_t>(i)); });
  points_ = distribute(points);
  ids_    = distribute(ids);
  const std::vector<char> is_active =
      distribute(active.empty() ? std::vector<char>(points.size(), 1) : active);
  inside_->find(points_, is_active, radius, pairs_);

  const auto counts_elsewhere = [&](const PointPair &pair)
  {
    const auto lower = ids_[pair.first] < ids_[pair.second] ? pair.first : pair.second;
    return grid.rank_at(points_[lower]) != rank_;
  };
  if (n_ranks_ > 1)
    pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), counts_elsewhere), pairs_.end());
}
} // namespace ricochet
