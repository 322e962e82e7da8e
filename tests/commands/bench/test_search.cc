// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/bench/search.h"
#include "commands/bench/search_points.h"

#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;

/// Counted one by one.
double pairs_of(const std::vector<Vector3> &points, const double radius)
{
  double n = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      n += (points[i] - points[j]).norm() < radius;
  return n;
}

TEST(SearchPoints, LatticeHasThePairsOfTheFormula)
{
  const auto points = search_points("lattice", 512, 0.8);
  ASSERT_EQ(points.size(), 512u);
  for (const double radius : {0.05, 0.101, 0.15, 0.31, 0.76})
    EXPECT_EQ(pairs_of(points, radius), lattice_pairs(8, 0.1, radius)) << radius;
}

TEST(SearchPoints, RandomOnesHaveAsManyPairsAsExpected)
{
  // A binomial number of pairs, hardly correlated: five standard deviations.
  const auto points     = search_points("random", 2000, 1.);
  const double expected = expected_random_pairs(2000., 1., 0.1);
  EXPECT_NEAR(pairs_of(points, 0.1), expected, 5. * std::sqrt(expected));
  // The whole cube lies within its diagonal; the formula holds up to its edge.
  EXPECT_NEAR(expected_random_pairs(2000., 1., 1.) / (0.5 * 2000. * 1999.), 0.9, 0.03);
}

TEST(BenchSearch, AllMethodsFindTheSamePairs)
{
  SearchBenchOptions options;
  options.points  = {1000};
  options.radius  = "12 mm";
  options.repeats = 1;
  options.json    = true;
  ::testing::internal::CaptureStdout();
  EXPECT_NO_THROW(bench_search(MPI_COMM_WORLD, options));
  const auto lines = split(::testing::internal::GetCapturedStdout(), '\n');
  if (rank() != 0)
  {
    EXPECT_TRUE(lines.empty());
    return;
  }
  ASSERT_EQ(lines.size(), (n_ranks() > 1 ? 2u : 1u) * 4u * 2u);
  for (const auto &line : lines)
  {
    const auto row = nlohmann::json::parse(line);
    if (row["arrangement"] == "lattice")
    {
      EXPECT_EQ(row["pairs"], row["expected_pairs"]) << line;
    }
    EXPECT_GT(row["seconds"], 0.);
  }
}
} // namespace
} // namespace ricochet
