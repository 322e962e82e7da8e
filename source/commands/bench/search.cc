// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bench/search.h"

#include "bench/harness.h"
#include "bench/search_points.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/search/hybrid_search.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
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
  std::int64_t n_points = 0;
  int n_processes       = 0;
  double seconds = 0., expected = 0.; // [s], pairs
  PairSum pairs;
};

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

/// Median of the times of `action`; the first time, which allocates memory, does not count.
double median_seconds(const MPI_Comm communicator, const int repeats,
                      const std::function<void()> &action)
{
  action();
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i)
    seconds.push_back(seconds_of(communicator, action));
  double time = median(seconds);
  MPI_Allreduce(MPI_IN_PLACE, &time, 1, MPI_DOUBLE, MPI_MAX, communicator);
  return time;
}

/// One method, in a row that knows the arrangement, on the processes of a communicator, all of
/// which have all points. The base methods take a share of the work each; the hybrid starts from a
/// share of the points each and hands them out to its blocks.
Row measure(const MPI_Comm communicator, Row row, const std::string &method,
            const std::vector<Vector3> &points, const double radius, const int repeats)
{
  const int rank = rank_in(communicator), n_ranks = size_of(communicator);
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
/// Measures everything in turn and prints it row by row.
class SearchBench
{
public:
  SearchBench(const MPI_Comm communicator, const SearchBenchOptions &options) :
    communicator_(communicator), options_(options), cube_(checked(options)),
    speaks_(rank_in(communicator) == 0)
  {
    for (const auto &search : pair_searches())
      methods_.push_back(search.name);
    methods_.push_back("hybrid");
  }

  void print_header() const
  {
    if (speaks_ && !options_.json)
      std::printf("All pairs closer than %g mm in a cube of %g mm; median of %d. Brute force only "
                  "up to %d points.\n%-12s %-14s %9s %9s %12s %12s %14s\n",
                  1e3 * cube_.radius, 1e3 * cube_.edge, options_.repeats,
                  options_.most_for_brute_force, "arrangement", "method", "points", "processes",
                  "ms", "pairs", "expected");
  }

  void measure_all(const std::string &arrangement, const int n_points)
  {
    const auto points = search_points(arrangement, n_points, cube_.edge);
    Row blank;
    blank.arrangement = arrangement;
    blank.expected    = expected_pairs(arrangement, n_points, cube_.edge, cube_.radius);
    std::vector<Row> results;
    for (const auto &method : methods_)
    {
      if (method == "brute force" && n_points > options_.most_for_brute_force)
        continue;
      const auto measured = [&](const MPI_Comm communicator)
      { return measure(communicator, blank, method, points, cube_.radius, options_.repeats); };
      if (speaks_)
        results.push_back(measured(MPI_COMM_SELF));
      if (speaks_)
        show(results.back());
      wait_for_first_rank(communicator_);
      if (size_of(communicator_) == 1)
        continue;
      results.push_back(measured(communicator_));
      show(results.back());
    }
    compare(results);
  }

  /// One JSON object per row so far; complete on rank 0.
  const std::string &rows() const { return rows_; }
  /// Who has found other pairs than whom; complete on rank 0.
  const std::string &difference() const { return difference_; }

private:
  void show(const Row &row)
  {
    const std::string json = to_json(row, cube_).dump();
    rows_ += json + "\n";
    if (!speaks_)
      return;
    if (options_.json)
      std::cout << json << std::endl;
    else
      print(row);
    std::fflush(stdout);
  }

  void compare(const std::vector<Row> &results)
  {
    for (const auto &row : results)
      if (row.pairs.n != results[0].pairs.n || row.pairs.hash != results[0].pairs.hash)
        difference_ += " " + row.method + " on " + std::to_string(row.n_processes) + " and " +
                       results[0].method + " on " + std::to_string(results[0].n_processes) +
                       " processes, " + std::to_string(row.n_points) + " points.";
  }

  MPI_Comm communicator_;
  const SearchBenchOptions &options_;
  Cube cube_;
  bool speaks_;
  std::vector<std::string> methods_;
  std::string rows_, difference_;
};
} // namespace

void bench_search(const MPI_Comm communicator, const SearchBenchOptions &options)
{
  SearchBench bench(communicator, options);
  bench.print_header();
  for (const auto &arrangement : options.arrangements)
    for (const int n : options.points)
      bench.measure_all(arrangement, n);

  if (!options.picture.empty())
  {
    const auto numbers = std::filesystem::path(options.picture).replace_extension(".jsonl");
    on_first_rank(communicator, [&] { write_file(numbers, bench.rows()); });
    draw_search_plot(communicator, numbers, options.picture, /*quiet=*/options.json);
  }
  // Known to rank 0, which has all rows; thrown on all.
  if (broadcast(communicator, !bench.difference().empty(), /*root=*/0))
    throw RunError("bench search: different pairs found by" + bench.difference());
}
} // namespace ricochet
