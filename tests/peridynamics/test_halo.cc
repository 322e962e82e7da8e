// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/halo.h"

#include <gtest/gtest.h>

#include <array>
#include <mpi.h>
#include <vector>

namespace ricochet::tests
{
namespace
{
TEST(Halo, GhostPlanesAreTheNeighboursOutermostOnes)
{
  int rank, n_ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  constexpr int n_planes = 13;
  const Lattice lattice({Vector3::Zero(), 1e-3, {n_planes, 5, 4}, false},
                        make_stencil(1e-3, 3., InfluenceFunction::cone), rank, n_ranks);
  const int reach = lattice.stencil().reach;
  Halo halo(MPI_COMM_WORLD, lattice, /*body=*/1);
  const auto value = [](const std::array<int, 3> &c, const int field, const int round)
  { return 1. + c[0] + 100. * c[1] + 1e4 * c[2] + 1e6 * field + 1e7 * round; };
  constexpr double untouched = -1.;
  for (int round = 0; round < 2; ++round)
  {
    std::vector<double> fields[2];
    for (int i = 0; i < 2; ++i)
    {
      fields[i].assign(lattice.size(), untouched);
      lattice.for_each_owned([&](const std::ptrdiff_t p)
                             { fields[i][p] = value(lattice.coordinates(p), i, round); });
    }
    halo.exchange({fields[0].data(), fields[1].data()});
    int n_ghosts = 0;
    for (int i = 0; i < 2; ++i)
      for (int x = lattice.first_plane() - reach;
           x < lattice.first_plane() + lattice.n_planes() + reach; ++x)
        for (int y = 0; y < 5; ++y)
          for (int z = 0; z < 4; ++z)
          {
            const auto p = lattice.index(x, y, z);
            n_ghosts += x >= 0 && x < n_planes && !lattice.owned(p);
            ASSERT_EQ(fields[i][p],
                      x < 0 || x >= n_planes ? untouched : value({x, y, z}, i, round));
          }
    const int n_neighbours = (rank > 0) + (rank + 1 < n_ranks);
    EXPECT_EQ(n_ghosts, 2 * n_neighbours * reach * 5 * 4);
  }
}
} // namespace
} // namespace ricochet::tests
