// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces on a cloud of debris that is spread over all ranks and over both sides of the symmetry
// plane: exactly those which one rank computes.
#include "ricochet/contact/exponential_friction.h"
#include "ricochet/contact/short_range_contact.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3;

struct Setup
{
  const char *name;
  bool mirrored;
  int n_bodies;
  bool friction = false;
};

void PrintTo(const Setup &setup, std::ostream *out)
{
  *out << setup.name;
}

class ForcesOnRanks : public testing::TestWithParam<Setup>
{
};

INSTANTIATE_TEST_SUITE_P(Clouds, ForcesOnRanks,
                         testing::Values(Setup{"OneBody", false, 1}, Setup{"OneHalfBody", true, 1},
                                         Setup{"TwoBodies", false, 2},
                                         Setup{"TwoHalfBodies", true, 2},
                                         Setup{"OneRoughBody", false, 1, true},
                                         Setup{"OneRoughHalfBody", true, 1, true},
                                         Setup{"TwoRoughHalfBodies", true, 2, true}),
                         [](const auto &info) { return info.param.name; });

using Key = std::array<int, 4>; // body and lattice coordinates

struct Result
{
  std::map<Key, Vector3> force;
  double energy, friction_work;
};

/// Bodies whose points lie anywhere in a box around the symmetry plane, twice: a search, then a
/// step without one.
Result cloud_forces(const MPI_Comm communicator, const Setup &setup)
{
  std::vector<std::unique_ptr<PeridynamicBody>> bodies;
  for (int number = 0; number < setup.n_bodies; ++number)
  {
    BodySample sample;
    sample.family.horizon_ratio = 2.;
    sample.n                    = {12, 6, 4};
    sample.number               = number;
    sample.mirror_y             = setup.mirrored;
    sample.critical_stretch     = 0.01;
    sample.communicator         = communicator;
    bodies.push_back(make_body(sample));
  }
  const ExponentialFriction law({0.5, 0.05, 0.01});
  ShortRangeContact::Friction friction;
  if (setup.friction)
    friction = {&law, 1., 5.};
  ShortRangeContact debris(communicator, bodies, 1., setup.mirrored, "linked cells", friction);
  for (const int seed : {67, 71})
  {
    for (const auto &body : bodies)
    {
      // All ranks go through all points, so that the numbers are the same however many they are.
      Random random(seed + (&body - bodies.data()));
      const Lattice &l = body->lattice();
      for (int x = 0; x < 12; ++x)
        for (int y = 0; y < 6; ++y)
          for (int z = 0; z < 4; ++z)
          {
            const Vector3 u = random.vector(), v = 100. * random.vector();
            if (x < l.first_plane() || x >= l.first_plane() + l.n_planes())
              continue;
            const auto p         = l.index(x, y, z);
            const Vector3 before = position(*body, p);
            set(body->state().arrays.position, p,
                seed == 67 ? Vector3(6. * dx * (1. + u.x()), 6. * dx * u.y(), 3. * dx * u.z())
                           : Vector3(before + 0.1 * dx * u));
            set(body->state().arrays.velocity, p, v);
          }
    }
    for (const auto &body : bodies)
    {
      body->update_ghosts();
      body->evaluate(/*breaking=*/true, /*energy=*/true);
    }
    debris.evaluate(1e-9);
  }
  Result result;
  for (const auto &body : bodies)
    for_each_point(*body,
                   [&](const std::ptrdiff_t p)
                   {
                     const auto c = body->lattice().coordinates(p);
                     result.force[{static_cast<int>(&body - bodies.data()), c[0], c[1], c[2]}] =
                         force(*body, p);
                   });
  result.energy = debris.energy();
  for (const auto &body : bodies)
    body->advance(1e-9, 0.);
  debris.record_work(1e-9);
  result.friction_work = debris.friction_work();
  return result;
}

TEST_P(ForcesOnRanks, DebrisCloudFeelsExactlyTheForcesOfOneRank)
{
  const auto all  = cloud_forces(MPI_COMM_WORLD, GetParam()),
             one  = cloud_forces(MPI_COMM_SELF, GetParam());
  int n_different = 0;
  for (const auto &[key, value] : all.force)
    n_different += one.force.at(key) != value;
  EXPECT_EQ(n_different, 0) << "of " << all.force.size() << " points";
  EXPECT_EQ(all.energy, one.energy);
  EXPECT_EQ(all.friction_work, one.friction_work);
  EXPECT_EQ(one.friction_work < 0., GetParam().friction);
  EXPECT_GT(one.energy, 0.);
}

TEST_P(ForcesOnRanks, DebrisCloudKeepsItsMomentum)
{
  // Over all ranks. The cloud lies on both sides of the plane: along the plane all forces cancel.
  const auto all = cloud_forces(MPI_COMM_WORLD, GetParam());
  double sum[4]  = {0., 0., 0., 0.};
  for (const auto &[key, value] : all.force)
  {
    for (int d = 0; d < 3; ++d)
      sum[d] += value[d];
    sum[3] += value.norm();
  }
  MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  if (GetParam().mirrored)
    sum[1] = 0.;
  EXPECT_GT(sum[3], 0.);
  EXPECT_LT(Vector3(sum[0], sum[1], sum[2]).norm(), 1e-13 * sum[3]);
}
} // namespace
} // namespace ricochet::tests
