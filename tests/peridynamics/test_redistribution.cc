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
  /// Of the owned points: of each bond the plastic extension, and whether it is a crack.
  std::map<std::array<int, 3>, std::vector<std::pair<double, bool>>> bonds;
  double n_bonds, viscous, plastic;
  bool any_crack = false;
};

PeridynamicMaterial material(const RelaxationSeries &series = {}, const bool cracks_push = false,
                             const FlowLaw &flow = {})
{
  return {&bond_law("linear peridynamic solid"), 1190.,       5.9e9, 2.258e9, critical, series,
          HistoryPrecision::single_precision,    cracks_push, flow};
}

/// A body that flies apart, half of it computed if mirrored.
Result burst(const MPI_Comm communicator, const bool mirrored, const PeridynamicMaterial &material,
             const bool redistribute)
{
  constexpr double dt = 2e-8;
  const Lattice::Box box{Vector3::Zero(), 1e-3, {n_planes, 6, 5}, mirrored};
  PeridynamicBody body(communicator, 0, box, make_stencil(box.spacing, 3., InfluenceFunction::cone),
                       material);
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
  for_each_point(
      body,
      [&](const std::ptrdiff_t p)
      {
        const auto place     = body.lattice().coordinates(p);
        result.motion[place] = {position(body, p), at(body.state().arrays.velocity, p)};
        for (std::size_t k = 0; k < body.bond_constants().size(); ++k)
        {
          const bool crack =
              (body.broken_bonds(p / 8, k) & ~body.parted_bonds(p / 8, k)) >> (p % 8) & 1;
          result.any_crack |= crack;
          result.bonds[place].push_back(
              {body.flow() == nullptr ? 0. : body.flow()->plastic_extension(p, k), crack});
        }
      });
  result.n_bonds = body.count_bonds();
  body.update_ghosts();
  body.compute_internal_forces({true});
  result.viscous = body.energies(dt).viscous;
  result.plastic = body.energies(dt).plastic;
  return result;
}

void expect_no_difference(const bool mirrored, const PeridynamicMaterial &material)
{
  const auto alone = burst(MPI_COMM_SELF, mirrored, material, false);
  EXPECT_EQ(alone.viscous > 0., !material.relaxation.empty());
  EXPECT_EQ(alone.plastic > 0., material.flow.flows());
  EXPECT_EQ(alone.any_crack, material.cracks_push);
  EXPECT_EQ(alone.motion.size(), std::size_t(n_planes * 6 * 5));
  for (const bool redistribute : {false, true})
  {
    const auto shared = burst(MPI_COMM_WORLD, mirrored, material, redistribute);
    int n_different   = 0;
    for (const auto &[place, value] : shared.motion)
      n_different +=
          alone.motion.at(place) != value || alone.bonds.at(place) != shared.bonds.at(place);
    EXPECT_EQ(n_different, 0) << "of " << shared.motion.size() << " points";
    EXPECT_EQ(shared.n_bonds, alone.n_bonds);
    EXPECT_EQ(shared.viscous, alone.viscous);
    EXPECT_EQ(shared.plastic, alone.plastic);
  }
}

TEST(Redistribution, ElasticBodyDoesNotNotice)
{
  expect_no_difference(false, material());
}

TEST(Redistribution, HalfBodyDoesNotNotice)
{
  expect_no_difference(true, material());
}

TEST(Redistribution, RelaxingHalfBodyDoesNotNotice)
{
  expect_no_difference(true, material({{0.3, 1e-6}, {0.2, 5e-7}}));
}

TEST(Redistribution, BodyWhoseCracksPushDoesNotNotice)
{
  for (const bool mirrored : {false, true})
    expect_no_difference(mirrored, material({}, true));
}

TEST(Redistribution, FlowingBodyDoesNotNotice)
{
  for (const bool mirrored : {false, true})
    expect_no_difference(mirrored, material({}, true, {20e6, 0.07, 0.2}));
}

TEST(Redistribution, BodyBreaksMeanwhile)
{
  const Lattice::Box box{Vector3::Zero(), 1e-3, {n_planes, 6, 5}, true};
  const auto stencil = make_stencil(box.spacing, 3., InfluenceFunction::cone);
  PeridynamicBody sound(MPI_COMM_SELF, 0, box, stencil, material());
  const double n    = sound.count_bonds(),
               left = burst(MPI_COMM_SELF, true, material(), false).n_bonds;
  EXPECT_LT(left, 0.9 * n) << "too little breaks for the tests above to mean much";
  EXPECT_GT(left, 0.1 * n);
}
} // namespace
} // namespace ricochet::tests
