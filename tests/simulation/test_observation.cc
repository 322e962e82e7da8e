// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/observation.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(Observation, PlatesAreWhereTheirPointsHaveGone)
{
  for (const bool half : {false, true})
  {
    Scene scene     = two_plates();
    scene.symmetric = half;
    Simulation simulation(MPI_COMM_WORLD, scene);
    const auto before = plate_places(simulation);
    ASSERT_EQ(before.size(), 2u);
    EXPECT_LT((before[0].low - Vector3(0., -8e-3, -4e-3)).norm(), 1e-15) << "both halves";
    EXPECT_LT((before[0].high - Vector3(30e-3, 8e-3, 0.)).norm(), 1e-15);
    EXPECT_EQ(before[0].velocity.norm(), 0.);

    auto &plate      = *simulation.plates()[0];
    auto &a          = plate.state().arrays;
    const double y   = half ? 0. : 3e-3;
    const Vector3 to = Vector3(1e-3, y, -2e-3), velocity(5., 1e3 * y, -7.);
    plate.lattice().for_each_owned(
        [&](const std::ptrdiff_t p)
        {
          for (int d = 0; d < 3; ++d)
          {
            a.position[d][p] += to[d];
            a.velocity[d][p] += velocity[d];
          }
        });
    const auto after = plate_places(simulation);
    EXPECT_LT((after[0].low - before[0].low - to).norm(), 1e-15);
    EXPECT_LT((after[0].high - before[0].high - to).norm(), 1e-15);
    EXPECT_LT((after[0].velocity - velocity).norm(), 1e-12);
    EXPECT_EQ(after[1].low, before[1].low) << "the other plate has not moved";
  }
}

TEST(Observation, IsWhatTheSimulationIs)
{
  Simulation simulation(MPI_COMM_WORLD, small_scene());
  simulation.compute_forces(false);
  const auto now = observe(simulation);
  EXPECT_EQ(now.time, 0.);
  EXPECT_EQ(now.position, simulation.projectile().motion().position);
  EXPECT_NEAR(now.velocity.norm(), 300., 1e-12 * 300.);
  EXPECT_FALSE(now.touching);
  EXPECT_EQ(now.plates().size(), 1u);
  const auto verdict = watch_of(simulation).verdict("it has not begun");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
}
} // namespace
} // namespace ricochet::tests
