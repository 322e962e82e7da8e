// SPDX-License-Identifier: LGPL-2.1-or-later
// The one file that knows nanoflann, whose interface changes between versions.
#include "cell_grid.h"
#include "ricochet/search/pair_search.h"

#include <nanoflann.hpp>

namespace ricochet
{
namespace
{
struct Cloud
{
  std::vector<Vector3> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(const std::size_t i, const std::size_t d) const { return points[i][d]; }
  template <class Box>
  bool kdtree_get_bbox(Box &) const
  {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3>;

/// Takes the neighbours of one point, as nanoflann's searches want it.
struct Neighbours
{
  const std::int32_t *number; // of the caller
  const char *active;         // null: all are
  double squared_radius;
  std::uint32_t centre;
  const Families &families;
  std::vector<PointPair> &pairs;

  bool addPoint(const double squared_distance, const std::uint32_t i)
  {
    // A pair of two active points is met twice.
    const bool first_time = i > centre || (active && !active[i] && i != centre);
    if (first_time && squared_distance < squared_radius &&
        !families.share(number[centre], number[i]))
      pairs.push_back({number[centre], number[i]});
    return true;
  }
  // The tree skips cells by sums that are rounded: nothing at the edge of the radius may be lost.
  double worstDist() const { return squared_radius * (1. + 1e-9); }
  bool full() const { return true; }
  std::size_t size() const { return pairs.size(); }
};

class KdTree : public PairSearch
{
  void search(const SearchPoints &all, const double radius, const SearchShare share,
              std::vector<PointPair> &pairs) const override
  {
    const auto &points = all.position;
    const auto &active = all.active;
    const CellGrid grid(points, active, radius);
    const auto &order = grid.order();
    if (order.empty())
      return;
    Cloud cloud;
    std::vector<char> is_active;
    cloud.points.reserve(order.size());
    for (const std::int32_t i : order)
    {
      cloud.points.push_back(points[i]);
      if (!active.empty())
        is_active.push_back(active[i]);
    }
    Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(/*leaf size*/ 10));
    tree.buildIndex();

    Neighbours neighbours{order.data(),    is_active.empty() ? nullptr : is_active.data(),
                          radius * radius, 0,
                          all.families,    pairs};
    const auto begin = order.size() * share.part / share.n_parts;
    const auto end   = order.size() * (share.part + 1) / share.n_parts;
    for (auto i = begin; i < end; ++i)
      if (is_active.empty() || is_active[i])
      {
        neighbours.centre = static_cast<std::uint32_t>(i);
        tree.findNeighbors(neighbours, cloud.points[i].data(), nanoflann::SearchParams());
      }
  }
};
} // namespace

std::unique_ptr<PairSearch> make_kd_tree()
{
  return std::make_unique<KdTree>();
}
} // namespace ricochet
