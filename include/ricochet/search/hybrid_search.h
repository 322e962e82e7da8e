// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of points that lie anywhere on all ranks, by the hybrid method: space is divided into one
// block of a grid per process, each block enlarged by the search radius, and searched with a
// KD-tree. A pair within the overlap of blocks is known to several of them; it counts where the
// point with the lower number lies.
#pragma once

#include "ricochet/base/exchange.h"
#include "ricochet/search/pair_search.h"

#include <array>
#include <mpi.h>
#include <vector>

namespace ricochet
{
/// One box per rank, which together fill space. Equal shares of the box around all points: their
/// numbers of points differ as the density does.
class BlockGrid
{
public:
  /// `points` of this rank [m]. Collective.
  BlockGrid(MPI_Comm communicator, const std::vector<Vector3> &points);

  /// The rank in whose block a point lies; the outer blocks reach to infinity.
  int rank_at(const Vector3 &x) const;
  /// Calls visit(rank) for all blocks that, enlarged by the radius [m], contain the point.
  template <class Visitor>
  void for_each_rank_near(const Vector3 &x, double radius, Visitor &&visit) const;

private:
  std::array<int, 3> block_at(const Vector3 &x) const;
  int rank_of(const int x, const int y, const int z) const { return (x * n_[1] + y) * n_[2] + z; }

  std::array<int, 3> n_;
  Vector3 low_, size_;
};

class HybridSearch
{
public:
  /// `method_inside`: that of each block, by its name in the menu of PairSearch. Collective.
  explicit HybridSearch(MPI_Comm communicator, const std::string &method_inside = "kd-tree");

  /**
   * The pairs of this rank's block. Collective.
   *
   * @param points   This rank's points, in any arrangement [m].
   * @param active   As in PairSearch::find().
   * @param ids      A number for each point, different from those of all other points of all ranks.
   * @param radius   > 0 [m], the same on all ranks.
   *
   * Afterwards ids() and points() tell what pairs() refers to.
   */
  void find(const std::vector<Vector3> &points, const std::vector<char> &active,
            const std::vector<std::int64_t> &ids, double radius);

  const std::vector<PointPair> &pairs() const { return pairs_; } // of points of the enlarged block
  const std::vector<Vector3> &points() const { return points_; } // of the enlarged block [m]
  const std::vector<std::int64_t> &ids() const { return ids_; }  // theirs

  /// Values of all points of the enlarged block, given those of the points handed to the last
  /// find(). Collective.
  template <class Value>
  std::vector<Value> distribute(const std::vector<Value> &values) const;

private:
  MPI_Comm communicator_;
  int rank_, n_ranks_;
  std::unique_ptr<PairSearch> inside_;
  std::vector<std::vector<std::int32_t>> routes_; // numbers of the points sent to each rank
  std::vector<Vector3> points_;
  std::vector<std::int64_t> ids_;
  std::vector<PointPair> pairs_;
};
template <class Visitor>
void BlockGrid::for_each_rank_near(const Vector3 &x, const double radius, Visitor &&visit) const
{
  const auto first = block_at(x - Vector3::Constant(radius));
  const auto last  = block_at(x + Vector3::Constant(radius));
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int k = first[2]; k <= last[2]; ++k)
        visit(rank_of(i, j, k));
}

template <class Value>
std::vector<Value> HybridSearch::distribute(const std::vector<Value> &values) const
{
  return joined(exchange_lists(communicator_, chosen(values, routes_)));
}
} // namespace ricochet
