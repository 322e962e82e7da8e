// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/bench/elements.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/kernels/hex_kernel.h"

#include <gtest/gtest.h>
#include <mpi.h>
#include <nlohmann/json.hpp>

#include <string>

namespace ricochet::tests
{
namespace
{
TEST(BenchElements, PrintsOneJsonObjectPerElement)
{
  for (const char *element : {"one point", "full", "own tensors"})
  {
    ElementBenchOptions options;
    options.elements_per_edge = 8;
    options.repeats           = 1;
    options.element           = element;
    options.json              = true;
    testing::internal::CaptureStdout();
    bench_elements(MPI_COMM_SELF, options);
    const auto result = nlohmann::json::parse(testing::internal::GetCapturedStdout());
    EXPECT_EQ(result["element"], element);
    EXPECT_EQ(result["instruction_set"], hex_kernel()->instruction_set);
    // 8^3 cubes, one of which became eight.
    EXPECT_EQ(result["elements"], 512 - 1 + 8);
    EXPECT_EQ(result["ranks"], 1);
    EXPECT_GT(result["element_steps_per_second_per_core"], 0.);
    options.branches = 1;
    testing::internal::CaptureStdout();
    bench_elements(MPI_COMM_SELF, options);
    const auto relaxing = nlohmann::json::parse(testing::internal::GetCapturedStdout());
    EXPECT_GT(relaxing["share_of_elastic_rate"], 0.);
  }
}

TEST(BenchElements, RefusesWhatItDoesNotKnow)
{
  ElementBenchOptions options;
  options.element = "tetrahedron";
  EXPECT_THROW(bench_elements(MPI_COMM_SELF, options), InputError);
  options                   = {};
  options.elements_per_edge = 7;
  EXPECT_THROW(bench_elements(MPI_COMM_SELF, options), InputError);
  options                 = {};
  options.instruction_set = "abacus";
  EXPECT_THROW(bench_elements(MPI_COMM_SELF, options), InputError);
}
} // namespace
} // namespace ricochet::tests
