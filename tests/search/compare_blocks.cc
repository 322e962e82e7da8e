// SPDX-License-Identifier: LGPL-2.1-or-later
// How the hybrid search would balance with blocks by Zoltan's recursive coordinate bisection
// instead of equal boxes (doc/contact_search.md). Not a test; built by `ninja compare_blocks`:
//
//   mpirun --oversubscribe --bind-to none -np 3 build/tests/compare_blocks POINTS random|debris
#include "ricochet/base/mpi_tools.h"
#include "ricochet/search/hybrid_search.h"
#include "support/random.h"

#include <zoltan_cpp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

namespace ricochet::tests
{
namespace
{
/// Boxes with equally many points, in place of BlockGrid; two ranks or more (Zoltan knows no boxes
/// of a single one).
class BisectedBlocks
{
public:
  BisectedBlocks(Zoltan &zoltan, const MPI_Comm communicator, const std::vector<Vector3> &points)
  {
    const std::function<void(ZOLTAN_ID_PTR)> name = [&](ZOLTAN_ID_PTR const names)
    {
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        names[2 * i]     = static_cast<ZOLTAN_ID_TYPE>(rank_in(communicator));
        names[2 * i + 1] = static_cast<ZOLTAN_ID_TYPE>(i);
      }
    };
    cloud_ = {&points, &name};
    tell(zoltan);
    int changes, n_global, n_local, n_in, n_out;
    ZOLTAN_ID_PTR in_global, in_local, out_global, out_local;
    int *in_rank, *in_part, *out_rank, *out_part;
    if (zoltan.LB_Partition(changes, n_global, n_local, n_in, in_global, in_local, in_rank, in_part,
                            n_out, out_global, out_local, out_rank, out_part) != ZOLTAN_OK)
      std::abort();
    boxes_.resize(size_of(communicator));
    for (std::size_t part = 0; part < boxes_.size(); ++part)
    {
      int n_dimensions;
      auto &[low, high] = boxes_[part];
      zoltan.RCB_Box(static_cast<int>(part), n_dimensions, low[0], low[1], low[2], high[0], high[1],
                     high[2]);
    }
  }

  int rank_at(const Vector3 &x) const
  {
    int rank = 0;
    for_each_rank_near(x, 0., [&](const int r) { rank = r; });
    return rank;
  }

  /// A box owns its upper faces, as Zoltan has it.
  template <class Visitor>
  void for_each_rank_near(const Vector3 &x, const double radius, Visitor &&visit) const
  {
    for (std::size_t rank = 0; rank < boxes_.size(); ++rank)
      if ((x.array() + radius > boxes_[rank].first.array()).all() &&
          (x.array() - radius <= boxes_[rank].second.array()).all())
        visit(static_cast<int>(rank));
  }

private:
  struct Cloud
  {
    const std::vector<Vector3> *points;
    const std::function<void(ZOLTAN_ID_PTR)> *name;
  };

  void tell(Zoltan &zoltan)
  {
    zoltan.Set_Num_Obj_Fn([](void *cloud, int *)
                          { return int(static_cast<Cloud *>(cloud)->points->size()); },
                          &cloud_);
    zoltan.Set_Obj_List_Fn([](void *cloud, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR, int,
                              float *, int *) { (*static_cast<Cloud *>(cloud)->name)(global); },
                           &cloud_);
    zoltan.Set_Num_Geom_Fn([](void *, int *) { return 3; }, nullptr);
    zoltan.Set_Geom_Multi_Fn(
        [](void *cloud, int, int, const int n, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR, int, double *x,
           int *)
        {
          for (int i = 0; i < n; ++i)
            std::copy_n((*static_cast<Cloud *>(cloud)->points)[global[2 * i + 1]].data(), 3,
                        x + 3 * i);
        },
        &cloud_);
  }

  Cloud cloud_;
  std::vector<std::pair<Vector3, Vector3>> boxes_; // lowest and highest corner [m]
};

struct Cloud
{
  std::vector<Vector3> points;
  double radius; // [m]
};

/// In a cube of 100 mm. "debris": nine tenths in a corner cube of 25 mm, as dense as a lattice in
/// which a point's contacts are searched within 1.85 spacings, and a tenth that has flown off.
Cloud make_cloud(const int n_points, const bool debris)
{
  const double edge = 0.1;
  Random random(71);
  const auto anywhere = [&]() -> Vector3
  { return 0.5 * edge * (random.vector() + Vector3::Ones()); };
  Cloud cloud;
  cloud.radius = 3e-3;
  if (debris)
  {
    const int n          = static_cast<int>(std::cbrt(0.9 * n_points));
    const double spacing = 0.25 * edge / n;
    cloud.radius         = 1.85 * spacing;
    for (int i = 0; i < n * n * n; ++i)
      cloud.points.push_back(
          spacing * (Vector3(i % n, i / n % n, i / n / n) + 0.5 * random.vector()).cwiseAbs());
  }
  while (static_cast<int>(cloud.points.size()) < n_points)
    cloud.points.push_back(anywhere());
  return cloud;
}

double processor_seconds()
{
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of this rank.
struct Cost
{
  double blocks = 0., search = 0.; // wall time to find the blocks, processor time to search [s]
  double points = 0., pairs = 0.;  // to search among, and found
};

/// HybridSearch::find() with other blocks.
template <class MakeBlocks>
Cost search(const std::vector<Vector3> &own, const std::vector<std::int64_t> &own_ids,
            const double radius, MakeBlocks &&make_blocks)
{
  Cost cost;
  MPI_Barrier(MPI_COMM_WORLD);
  const double start = MPI_Wtime();
  const auto blocks  = make_blocks();
  cost.blocks        = MPI_Wtime() - start;

  double begin = processor_seconds();
  std::vector<std::vector<std::int32_t>> routes(size_of(MPI_COMM_WORLD));
  for (std::size_t i = 0; i < own.size(); ++i)
    blocks.for_each_rank_near(own[i], radius * (1. + 1e-9),
                              [&](const int rank)
                              { routes[rank].push_back(static_cast<std::int32_t>(i)); });
  cost.search       = processor_seconds() - begin;
  const auto points = joined(exchange_lists(MPI_COMM_WORLD, chosen(own, routes)));
  const auto ids    = joined(exchange_lists(MPI_COMM_WORLD, chosen(own_ids, routes)));

  begin = processor_seconds();
  std::vector<PointPair> pairs;
  make_pair_search("kd-tree")->find(points, {}, radius, pairs);
  for (const auto &pair : pairs)
  {
    const auto lower = ids[pair.first] < ids[pair.second] ? pair.first : pair.second;
    cost.pairs += blocks.rank_at(points[lower]) == rank_in(MPI_COMM_WORLD);
  }
  cost.search += processor_seconds() - begin;
  cost.points = static_cast<double>(points.size());
  return cost;
}

/// Largest and sum over the ranks.
std::pair<double, double> over_ranks(const double value)
{
  double largest = value, sum = value;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return {largest, sum};
}

/// Medians, and counts of the last.
void print(const char *name, const std::vector<Cost> &costs)
{
  const int n_ranks = size_of(MPI_COMM_WORLD);
  std::vector<double> blocks, busiest, together;
  for (const auto &cost : costs)
  {
    blocks.push_back(over_ranks(cost.blocks).first);
    const auto [largest, sum] = over_ranks(cost.search);
    busiest.push_back(largest);
    together.push_back(sum);
  }
  const auto median = [](std::vector<double> &values)
  {
    std::sort(values.begin(), values.end());
    return 1e3 * values[values.size() / 2];
  };
  const auto [most_points, points] = over_ranks(costs.back().points);
  const auto [most_pairs, pairs]   = over_ranks(costs.back().pairs);
  const double least               = *std::min_element(blocks.begin(), blocks.end());
  if (rank_in(MPI_COMM_WORLD) == 0)
    std::printf("%-8s blocks %7.2f ms (least %.2f), search: busiest rank %7.2f ms, all %7.2f ms; "
                "most over mean: points %.2f, pairs %.2f; %.0f points, %.0f pairs\n",
                name, median(blocks), 1e3 * least, median(busiest), median(together),
                n_ranks * most_points / points, n_ranks * most_pairs / pairs, points, pairs);
}

void compare(const Cloud &cloud)
{
  const int n_ranks = size_of(MPI_COMM_WORLD), rank = rank_in(MPI_COMM_WORLD);
  std::vector<Vector3> own;
  std::vector<std::int64_t> ids;
  for (std::size_t i = rank; i < cloud.points.size(); i += n_ranks)
  {
    own.push_back(cloud.points[i]);
    ids.push_back(static_cast<std::int64_t>(i));
  }
  Zoltan zoltan(MPI_COMM_WORLD);
  for (const auto &[name, value] : {std::pair<const char *, const char *>{"LB_METHOD", "RCB"},
                                    {"KEEP_CUTS", "1"},
                                    {"RETURN_LISTS", "NONE"},
                                    {"DEBUG_LEVEL", "0"},
                                    {"NUM_GID_ENTRIES", "2"},
                                    {"NUM_LID_ENTRIES", "0"},
                                    {"RCB_REUSE", "1"},
                                    {"IMBALANCE_TOL", "1.03"}})
    zoltan.Set_Param(name, value);
  // A B A B; the first of each, which allocates memory, does not count.
  std::vector<Cost> boxes, bisected;
  for (int i = 0; i < 12; ++i)
  {
    const auto a = search(own, ids, cloud.radius, [&] { return BlockGrid(MPI_COMM_WORLD, own); });
    const auto b =
        search(own, ids, cloud.radius, [&] { return BisectedBlocks(zoltan, MPI_COMM_WORLD, own); });
    if (i > 0)
    {
      boxes.push_back(a);
      bisected.push_back(b);
    }
  }
  print("boxes", boxes);
  print("Zoltan", bisected);
}
} // namespace
} // namespace ricochet::tests

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  float version;
  Zoltan_Initialize(argc, argv, &version);
  if (argc == 3 && ricochet::size_of(MPI_COMM_WORLD) > 1)
    ricochet::tests::compare(
        ricochet::tests::make_cloud(std::atoi(argv[1]), std::string(argv[2]) == "debris"));
  MPI_Finalize();
}
