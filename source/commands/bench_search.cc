// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench_search.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/search/hybrid_search.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <random>
#include <thread>

namespace ricochet
{
namespace
{
/// Pairs of one process, told apart by their sum of hashes, which does not depend on their order.
struct PairSum
{
  std::uint64_t n = 0, hash = 0;

  void add(std::int64_t a, std::int64_t b)
  {
    if (b < a)
      std::swap(a, b);
    std::uint64_t h = (std::uint64_t(a) << 32 | std::uint64_t(b)) * 0x9e3779b97f4a7c15ull;
    h               = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull;
    hash += h ^ (h >> 32);
    ++n;
  }
};

/// The options as numbers, checked.
struct Cube
{
  double edge, radius; // [m]
};

struct Row
{
  std::string arrangement, method;
  std::int64_t n_points;
  int n_processes;
  double seconds, expected;
  PairSum pairs;
};

int lattice_size(const int n_points)
{
  return std::max(1, static_cast<int>(std::lround(std::cbrt(n_points))));
}

std::vector<Vector3> make_points(const std::string &arrangement, const int n_points,
                                 const double edge)
{
  std::vector<Vector3> points;
  if (arrangement == "lattice")
  {
    const int n          = lattice_size(n_points);
    const double spacing = edge / n;
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
          points.push_back(spacing * Vector3(x + 0.5, y + 0.5, z + 0.5));
    return points;
  }
  // Not std::uniform_real_distribution: the same points with every standard library.
  std::mt19937_64 engine(20240601);
  const auto uniform = [&] { return edge * std::ldexp(static_cast<double>(engine() >> 11), -53); };
  for (int i = 0; i < n_points; ++i)
  {
    const double x = uniform(), y = uniform(), z = uniform();
    points.emplace_back(x, y, z);
  }
  return points;
}

/// The others sleep until rank 0 has finished: spinning, they would slow it down.
void wait_for_first_rank(const MPI_Comm communicator)
{
  MPI_Request request;
  MPI_Ibarrier(communicator, &request);
  for (int done = 0; !done;)
  {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Median of the times of `action`, the slowest process counting.
template <class Action>
double median_seconds(const MPI_Comm communicator, const int repeats, Action &&action)
{
  std::vector<double> seconds;
  for (int i = 0; i <= repeats; ++i)
  {
    MPI_Barrier(communicator);
    const auto start = std::chrono::steady_clock::now();
    action();
    double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    MPI_Allreduce(MPI_IN_PLACE, &time, 1, MPI_DOUBLE, MPI_MAX, communicator);
    if (i > 0) // the first one allocates memory
      seconds.push_back(time);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// One method on the processes of a communicator, all of which have all points. The base methods
/// take a share of the work each; the hybrid starts from a share of the points each and hands them
/// out to its blocks.
Row measure(const MPI_Comm communicator, const std::string &method,
            const std::vector<Vector3> &points, const double radius, const int repeats)
{
  const int rank = rank_in(communicator), n_ranks = size_of(communicator);
  Row row;
  row.method      = method;
  row.n_points    = static_cast<std::int64_t>(points.size());
  row.n_processes = n_ranks;
  if (method == "hybrid")
  {
    const auto share = [&](const int r) { return points.size() * r / n_ranks; };
    const std::vector<Vector3> own(points.begin() + share(rank), points.begin() + share(rank + 1));
    std::vector<std::int64_t> ids(own.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      ids[i] = static_cast<std::int64_t>(share(rank) + i);
    HybridSearch search(communicator);
    row.seconds = median_seconds(communicator, repeats, [&] { search.find(own, {}, ids, radius); });
    for (const auto &pair : search.pairs())
      row.pairs.add(search.ids()[pair.first], search.ids()[pair.second]);
  }
  else
  {
    const auto search = make_pair_search(method);
    std::vector<PointPair> pairs;
    row.seconds = median_seconds(communicator, repeats,
                                 [&] {
                                   search->find(points, {}, radius, pairs, {rank, n_ranks});
                                 });
    for (const auto &pair : pairs)
      row.pairs.add(pair.first, pair.second);
  }
  MPI_Allreduce(MPI_IN_PLACE, &row.pairs.n, 1, MPI_UINT64_T, MPI_SUM, communicator);
  MPI_Allreduce(MPI_IN_PLACE, &row.pairs.hash, 1, MPI_UINT64_T, MPI_SUM, communicator);
  return row;
}

Cube checked(const SearchBenchOptions &options)
{
  const auto refuse = [](const std::string &why) { throw InputError("bench search: " + why); };
  const auto length = [&](const char *option, const std::string &text)
  {
    const auto parsed = parse_quantity(text, Dimension::length, Limit::positive);
    if (!parsed.problem.empty())
      refuse(std::string(option) + " '" + text + "': " + parsed.problem + " Write '3 mm'.");
    return parsed.value;
  };
  const Cube cube{length("--edge", options.edge), length("--radius", options.radius)};
  if (cube.radius > cube.edge)
    refuse("the radius must not be above the edge of the cube.");
  for (const int n : options.points)
    if (n < 2 || n > 100000000)
      refuse("--points " + std::to_string(n) + " must lie in 2 to 100000000.");
  if (options.points.empty() || options.repeats < 1)
    refuse("--points needs a number and --repeats must be at least 1.");
  for (const auto &arrangement : options.arrangements)
    if (arrangement != "random" && arrangement != "lattice")
      refuse("there is no arrangement '" + arrangement + "'; choose random or lattice.");
  return cube;
}

nlohmann::ordered_json to_json(const Row &row, const Cube &cube)
{
  nlohmann::ordered_json json;
  json["arrangement"]    = row.arrangement;
  json["method"]         = row.method;
  json["points"]         = row.n_points;
  json["processes"]      = row.n_processes;
  json["radius_m"]       = cube.radius;
  json["edge_m"]         = cube.edge;
  json["seconds"]        = row.seconds;
  json["pairs"]          = row.pairs.n;
  json["expected_pairs"] = row.expected;
  json["pair_hash"]      = row.pairs.hash;
  return json;
}

void print(const Row &row)
{
  std::printf("%-12s %-14s %9lld %9d %12.3f %12llu %14.1f\n", row.arrangement.c_str(),
              row.method.c_str(), static_cast<long long>(row.n_points), row.n_processes,
              1e3 * row.seconds, static_cast<unsigned long long>(row.pairs.n), row.expected);
}
} // namespace

double expected_random_pairs(const double n_points, const double edge, const double radius)
{
  // The difference of two points uniform in the unit cube has the density (1 - |x|)(1 - |y|)(1 -
  // |z|); its integral over the ball of radius r <= 1, where |x|, |x y| and |x y z| integrate to
  // pi r^4/2, 8 r^5/15 and r^6/6, is the share of pairs closer than r.
  const double r           = radius / edge;
  const double probability = 4. / 3. * M_PI * std::pow(r, 3) - 3. / 2. * M_PI * std::pow(r, 4) +
                             8. / 5. * std::pow(r, 5) - std::pow(r, 6) / 6.;
  return 0.5 * n_points * (n_points - 1.) * probability;
}

double lattice_pairs(const int n, const double spacing, const double radius)
{
  // Every offset, here those with positive coordinates, fits (n - |x|)(n - |y|)(n - |z|) times.
  const int reach = std::min(n - 1, static_cast<int>(radius / spacing) + 1);
  double directed = 0.;
  for (int x = 0; x <= reach; ++x)
    for (int y = 0; y <= reach; ++y)
      for (int z = 0; z <= reach; ++z)
        if (x + y + z > 0 && spacing * std::sqrt(x * x + y * y + z * z) < radius)
          directed += (x ? 2. : 1.) * (y ? 2. : 1.) * (z ? 2. : 1.) * (n - x) * (n - y) * (n - z);
  return 0.5 * directed;
}

void bench_search(const MPI_Comm communicator, const SearchBenchOptions &options)
{
  const Cube cube = checked(options);
  const int rank = rank_in(communicator), n_ranks = size_of(communicator);
  std::vector<std::string> methods;
  for (const auto &search : pair_searches())
    methods.push_back(search.name);
  methods.push_back("hybrid");

  if (rank == 0 && !options.json)
    std::printf("All pairs closer than %g mm in a cube of %g mm; median of %d. Brute force only up "
                "to %d points.\n%-12s %-14s %9s %9s %12s %12s %14s\n",
                1e3 * cube.radius, 1e3 * cube.edge, options.repeats, options.most_for_brute_force,
                "arrangement", "method", "points", "processes", "ms", "pairs", "expected");
  std::string rows, difference;
  for (const auto &arrangement : options.arrangements)
    for (const int n : options.points)
    {
      const auto points     = make_points(arrangement, n, cube.edge);
      const int size        = lattice_size(n);
      const double expected = arrangement == "lattice"
                                  ? lattice_pairs(size, cube.edge / size, cube.radius)
                                  : expected_random_pairs(n, cube.edge, cube.radius);
      std::vector<Row> results;
      const auto take = [&](Row row)
      {
        row.arrangement = arrangement;
        row.expected    = expected;
        if (rank == 0)
        {
          if (options.json)
            std::cout << to_json(row, cube).dump() << std::endl;
          else
            print(row);
          std::fflush(stdout);
        }
        rows += to_json(row, cube).dump() + "\n";
        results.push_back(row);
      };
      for (const auto &method : methods)
      {
        if (method == "brute force" && n > options.most_for_brute_force)
          continue;
        if (rank == 0)
          take(measure(MPI_COMM_SELF, method, points, cube.radius, options.repeats));
        wait_for_first_rank(communicator);
        if (n_ranks > 1)
          take(measure(communicator, method, points, cube.radius, options.repeats));
      }
      for (const auto &row : results)
        if (row.pairs.n != results[0].pairs.n || row.pairs.hash != results[0].pairs.hash)
          difference += " " + row.method + " on " + std::to_string(row.n_processes) + " and " +
                        results[0].method + " on " + std::to_string(results[0].n_processes) +
                        " processes, " + std::to_string(row.n_points) + " points.";
    }

  if (!options.picture.empty())
  {
    const auto numbers = std::filesystem::path(options.picture).replace_extension(".jsonl");
    on_first_rank(communicator, [&] { write_file(numbers, rows); });
    draw_search_plot(communicator, numbers, options.picture, /*quiet=*/options.json);
  }
  // Known to rank 0, which has all rows; thrown on all.
  if (broadcast(communicator, !difference.empty(), /*root=*/0))
    throw RunError("bench search: different pairs found by" + difference);
}
} // namespace ricochet
