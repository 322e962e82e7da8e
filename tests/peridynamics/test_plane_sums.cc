// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/plane_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mpi.h>

namespace ricochet::tests
{
namespace
{
TEST(PlaneSums, DoNotDependOnTheNumberOfRanksNotEvenByRounding)
{
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  constexpr int n_planes = 40;
  // Of very different size, so that another order would round otherwise.
  const auto part        = [](const int plane, const int i)
  { return std::pow(10., (7 * plane + 3 * i) % 17) / (plane + 3.); };
  PlaneSums<2> sums(n_planes);
  std::array<double, 2> in_order{};
  double backwards = 0.;
  for (int plane = 0; plane < n_planes; ++plane)
    for (int i = 0; i < 2; ++i)
    {
      in_order[i] += part(plane, i);
      if (plane * n_ranks / n_planes == rank)
        sums[plane][i] += part(plane, i);
    }
  for (int plane = n_planes - 1; plane >= 0; --plane)
    backwards += part(plane, 0);
  ASSERT_NE(backwards, in_order[0]) << "the numbers do not show what they should";
  EXPECT_EQ(sums.total(MPI_COMM_WORLD), in_order);
  sums.clear();
  EXPECT_EQ(sums.total(MPI_COMM_WORLD), (std::array<double, 2>{}));
}
} // namespace
} // namespace ricochet::tests
