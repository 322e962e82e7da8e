// SPDX-License-Identifier: LGPL-2.1-or-later
#include "peridynamics/plane_exchange.h"

#include <gtest/gtest.h>

#include <array>
#include <mpi.h>
#include <vector>

namespace ricochet::tests
{
namespace
{
constexpr int n_planes = 17;

/// Fills owned planes and moves them; `per_point` numbers for each point, or fewer than one.
template <class T>
void expect_planes_follow(const Lattice &from, const Lattice &to, const double per_point)
{
  const auto stride = static_cast<std::ptrdiff_t>(from.plane_stride() * per_point);
  const int reach   = from.stencil().reach;
  const auto value  = [&](const int x, const std::ptrdiff_t i)
  { return static_cast<T>((31 * x + 7 * i) % 127 + 1); };
  const auto place = [&](const Lattice &l, const int x)
  { return (x - l.first_plane() + reach) * stride; };
  std::vector<T> field(static_cast<std::size_t>(from.size() * per_point), T{});
  for (int x = from.first_plane(); x < from.first_plane() + from.n_planes(); ++x)
    for (std::ptrdiff_t i = 0; i < stride; ++i)
      field[place(from, x) + i] = value(x, i);
  const PlaneExchange planes(MPI_COMM_WORLD, from, to);
  planes.move(field, per_point);
  ASSERT_EQ(field.size(), static_cast<std::size_t>(to.size() * per_point));
  for (int x = to.first_plane() - reach; x < to.first_plane() + to.n_planes() + reach; ++x)
    for (std::ptrdiff_t i = 0; i < stride; ++i)
      ASSERT_EQ(field[place(to, x) + i], x < 0 || x >= n_planes ? T{} : value(x, i)) << x;
}

TEST(PlaneExchange, EveryPlaneAndGhostTakesOverFromItsOldOwner)
{
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  const Lattice even({Vector3::Zero(), 1e-3, {n_planes, 5, 3}, false},
                     make_stencil(1e-3, 3., InfluenceFunction::cone), rank, n_ranks);
  const int reach = even.stencil().reach;
  for (int large = 0; large < n_ranks; ++large)
  {
    std::vector<int> starts{0};
    for (int r = 0; r < n_ranks; ++r)
      starts.push_back(starts.back() + (r == large ? n_planes - (n_ranks - 1) * reach : reach));
    const Lattice uneven(even, starts, rank);
    expect_planes_follow<double>(even, uneven, 1.);
    expect_planes_follow<double>(uneven, even, 1.);
    expect_planes_follow<char>(even, uneven, 1.);
    expect_planes_follow<float>(even, uneven, 6.);              // histories
    expect_planes_follow<std::uint8_t>(even, uneven, 46. / 8.); // bonds
  }
}
} // namespace
} // namespace ricochet::tests
