// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/coupled_plate.h"

#include "ricochet/coupling/adaptive_zone.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double watched = 0.005; // stretch [-]

CoupledSample plate_with_column()
{
  CoupledSample sample;
  sample.communicator     = MPI_COMM_SELF;
  sample.n_cells          = {28, 28, 4};
  sample.zone             = {{8, 8, 0}, {20, 20, 4}};
  sample.critical_stretch = 0.01;
  return sample;
}

AdaptiveZone::Parameters parameters(const bool adaptive)
{
  return {watched, adaptive};
}

/// Moves one free point by so many spacings along x: its bonds stretch by at most as much.
void pull(PlateModel &plate, const Zone::Cell &cell, const double spacings)
{
  const auto p = plate.points->lattice().index(2 * cell[0], 2 * cell[1], 2 * cell[2]);
  ASSERT_TRUE(plate.points->lattice().free(p));
  plate.points->state().arrays.position[0][p] += spacings * plate.spacing;
  plate.points->update_ghosts();
}

constexpr double dt = 1e-6;

TEST(AdaptiveZone, QuietPlateIsLeftAlone)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  const auto n_free = plate.zone->n_free_cells();
  for (int step = 0; step < 12; ++step)
    EXPECT_FALSE(watch.update(step * dt, dt));
  EXPECT_EQ(watch.n_conversions(), 0);
  EXPECT_LT(watch.reached(), 0.);
  EXPECT_EQ(watch.loss(), 0.);
  EXPECT_EQ(plate.zone->n_free_cells(), n_free);
}

TEST(AdaptiveZone, FixedZoneSaysWhenItWasReached)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(false));
  EXPECT_FALSE(watch.update(0., dt));
  EXPECT_LT(watch.reached(), 0.);
  pull(plate, {9, 14, 2}, 0.008);
  for (int step = 1; step < 20; ++step)
    EXPECT_FALSE(watch.update(step * dt, dt));
  EXPECT_DOUBLE_EQ(watch.reached(),
                   AdaptiveZone::steps_between_looks *
                       dt); // the next look, and the first one counts
  EXPECT_EQ(watch.n_conversions(), 0);
}

TEST(AdaptiveZone, StretchBelowTheLimitOrFarFromTheInterfaceDoesNotMatter)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  pull(plate, {9, 14, 2}, 0.004);
  pull(plate, {14, 14, 2}, 0.008); // five cells inside
  for (int step = 0; step < 12; ++step)
    EXPECT_FALSE(watch.update(step * dt, dt));
  EXPECT_LT(watch.reached(), 0.);
}

TEST(AdaptiveZone, AdaptiveZoneGrowsByColumnsOfBricks)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  pull(plate, {8, 14, 2}, -0.008);
  EXPECT_TRUE(watch.update(0., dt));
  EXPECT_EQ(watch.n_conversions(), 1);
  EXPECT_LT(watch.reached(), 0.);
  // The bond's other end may lie up to two points, a cell, away: three cells around both, in bricks
  // of four.
  plate.zone->for_each_cell(
      [&](const Zone::Cell &cell)
      {
        const bool before = cell[0] >= 8 && cell[0] < 20 && cell[1] >= 8 && cell[1] < 20;
        const bool grown  = cell[0] >= 4 && cell[0] < 8 && cell[1] >= 8 && cell[1] < 20;
        EXPECT_EQ(plate.zone->is_free(cell), before || grown)
            << cell[0] << ' ' << cell[1] << ' ' << cell[2];
      });
  // The interface is now far away.
  for (int step = 1; step < 12; ++step)
    EXPECT_FALSE(watch.update(step * dt, dt));
  EXPECT_EQ(watch.n_conversions(), 1);
  // Points are where they were, and the plate is in equilibrium but for the one point.
  const auto &lattice = plate.points->lattice();
  EXPECT_DOUBLE_EQ(plate.points->state().arrays.position[0][lattice.index(10, 28, 4)],
                   10.5 * plate.spacing);
}

TEST(AdaptiveZone, ZoneAtItsLimitIsReported)
{
  auto limited  = plate_with_column();
  limited.limit = limited.zone;
  PlateModel plate(limited);
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  pull(plate, {8, 14, 2}, -0.008);
  EXPECT_FALSE(watch.update(3e-6, dt));
  EXPECT_EQ(watch.n_conversions(), 0);
  EXPECT_DOUBLE_EQ(watch.reached(), 3e-6);
}

TEST(AdaptiveZone, ZoneWaitsForTheProjectileWithoutHavingReachedItsLimit)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  pull(plate, {19, 14, 2}, 0.008);
  const double edge = 40. * plate.spacing; // of the zone
  EXPECT_FALSE(watch.update(0., dt, edge - 1e-6));
  EXPECT_LT(watch.reached(), 0.);
  for (int step = 1; step < AdaptiveZone::steps_between_looks; ++step)
    EXPECT_FALSE(watch.update(step * dt, dt, edge + 1e-6)) << "between two looks";
  EXPECT_TRUE(watch.update(1., dt, edge + 1e-6));
  EXPECT_LT(watch.reached(), 0.);
  EXPECT_TRUE(plate.zone->is_free({23, 14, 2}));
  EXPECT_FALSE(plate.zone->is_free({24, 14, 2}));
}

TEST(AdaptiveZone, LossIsTheEnergyThatIsMissingAfterwards)
{
  PlateModel plate(plate_with_column());
  AdaptiveZone watch(MPI_COMM_SELF, *plate.far, parameters(true));
  // A motion that elements with lumped masses and points hold differently.
  plate.set_velocity(
      [&](const Vector3 &X) -> Vector3 {
        return {0.1 * std::sin(X.x() / 2e-3), 0., 0.};
      });
  pull(plate, {8, 14, 2}, -0.008);
  const auto energy = [&]
  {
    plate.points->update_ghosts();
    plate.points->evaluate(false, true);
    plate.far->evaluate(true);
    return plate.far->energies(dt).total();
  };
  const double before = energy();
  EXPECT_TRUE(watch.update(0., dt));
  EXPECT_GT(watch.loss(), 0.);
  EXPECT_NEAR(before - energy(), watch.loss(), 1e-12 * before);
}
} // namespace
} // namespace ricochet::tests
