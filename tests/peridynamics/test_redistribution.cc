// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes of a body change their rank in the middle of its motion: to the last bit as if nothing had
// happened.
#include "support/body.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
constexpr int n_planes    = 18;
constexpr double critical = 0.01; // stretch [-]

/// Shares as unequal as three ranks allow, the large one on the given rank.
std::vector<int> uneven_shares(const int n_ranks, const int reach, const int large)
{
  std::vector<int> starts{0};
  for (int rank = 0; rank < n_ranks; ++rank)
    starts.push_back(starts.back() + (rank == large ? n_planes - (n_ranks - 1) * reach : reach));
  return starts;
}

struct Result
{
  std::map<std::array<int, 3>, std::array<Vector3, 2>> motion; // position and velocity
  double n_bonds, viscous;
};

/// A body that flies apart, half of it computed if mirrored.
Result burst(const MPI_Comm communicator, const bool mirrored, const RelaxationSeries &series,
             const bool redistribute)
{
  constexpr double dt = 2e-8;
  const Lattice::Box box{Vector3::Zero(), 1e-3, {n_planes, 6, 5}, mirrored};
  PeridynamicBody body(
      communicator, 0, box, make_stencil(box.spacing, 3., InfluenceFunction::cone),
      {&bond_law("linear peridynamic solid"), 1190., 5.9e9, 2.258e9, critical, series});
  body.start_relaxation(dt);
  Random random(5);
  for (int x = 0; x < n_planes; ++x)
    for (int y = 0; y < box.n[1]; ++y)
      for (int z = 0; z < box.n[2]; ++z)
      {
        const Vector3 v  = 60. * random.vector();
        const Lattice &l = body.lattice();
        if (x >= l.first_plane() && x < l.first_plane() + l.n_planes())
          set(body.state().arrays.velocity, l.index(x, y, z), v);
      }
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  for (int step = 0; step < 40; ++step)
  {
    if (redistribute && step % 8 == 7)
      body.redistribute(uneven_shares(n_ranks, body.lattice().stencil().reach, step / 8 % n_ranks));
    body.update_ghosts();
    body.break_bonds();
    body.compute_internal_forces({step % 5 == 0});
    body.advance(dt, dt);
  }
  Result result;
  for_each_point(body,
                 [&](const std::ptrdiff_t p)
                 {
                   result.motion[body.lattice().coordinates(p)] = {
                       position(body, p), at(body.state().arrays.velocity, p)};
                 });
  result.n_bonds = body.count_bonds();
  body.update_ghosts();
  body.compute_internal_forces({true});
  result.viscous = body.energies(dt).viscous;
  return result;
}

void expect_no_difference(const bool mirrored, const RelaxationSeries &series)
{
  const auto moved  = burst(MPI_COMM_WORLD, mirrored, series, true),
             stayed = burst(MPI_COMM_SELF, mirrored, series, false);
  int n_different   = 0;
  for (const auto &[place, value] : moved.motion)
    n_different += stayed.motion.at(place) != value;
  EXPECT_EQ(n_different, 0) << "of " << moved.motion.size() << " points";
  EXPECT_EQ(moved.n_bonds, stayed.n_bonds);
  EXPECT_EQ(moved.viscous, stayed.viscous);
  EXPECT_EQ(stayed.viscous > 0., !series.empty());
  EXPECT_EQ(stayed.motion.size(), std::size_t(n_planes * 6 * 5));
}

TEST(Redistribution, ElasticBodyDoesNotNotice)
{
  expect_no_difference(false, {});
}

TEST(Redistribution, HalfBodyDoesNotNotice)
{
  expect_no_difference(true, {});
}

TEST(Redistribution, RelaxingHalfBodyDoesNotNotice)
{
  expect_no_difference(true, {{0.3, 1e-6}, {0.2, 5e-7}});
}

TEST(Redistribution, BodyBreaksMeanwhile)
{
  const Lattice::Box box{Vector3::Zero(), 1e-3, {n_planes, 6, 5}, true};
  const auto stencil = make_stencil(box.spacing, 3., InfluenceFunction::cone);
  PeridynamicBody sound(MPI_COMM_SELF, 0, box, stencil,
                        {&bond_law("linear peridynamic solid"), 1190., 5.9e9, 2.258e9, critical});
  const double n = sound.count_bonds(), left = burst(MPI_COMM_SELF, true, {}, false).n_bonds;
  EXPECT_LT(left, 0.9 * n) << "too little breaks for the tests above to mean much";
  EXPECT_GT(left, 0.1 * n);
}
} // namespace
} // namespace ricochet::tests
