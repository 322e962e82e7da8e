// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/damage_report.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
/// A small impact after so many steps.
struct Impact
{
  Impact(const MPI_Comm communicator, const Scene &scene, const int n_steps) :
    simulation(communicator, scene), report(communicator, simulation)
  {
    for (int i = 0; i < n_steps; ++i)
    {
      simulation.compute_forces(false);
      simulation.advance();
    }
  }

  Simulation simulation;
  DamageReport report;
};

TEST(DamageReport, SoundPlatesHaveNone)
{
  const Impact impact(MPI_COMM_WORLD, two_plates(), 0);
  EXPECT_EQ(impact.report.n_bonds(), impact.simulation.n_bonds());
  for (const auto &plate : impact.report.plates())
  {
    EXPECT_EQ(plate.broken_share, 0.);
    EXPECT_EQ(plate.front_area, 0.);
    EXPECT_EQ(plate.rear_area, 0.);
  }
}

TEST(DamageReport, NumbersAgreeWithTheMapsAndTheBondsThatBroke)
{
  const Scene scene = symmetric(two_plates());
  const Impact impact(MPI_COMM_WORLD, scene, 150);
  const auto plates = impact.report.plates();
  const auto maps   = impact.report.maps();
  ASSERT_EQ(plates.size(), 2u);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_GT(plates[0].front_area, 0.);

  // Shares are those of the bonds of whole plates.
  const double lost = impact.report.n_bonds() - impact.simulation.n_bonds();
  double sum        = 0.;
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (std::size_t i = 0; i < 2; ++i)
  {
    sum += plates[i].broken_share * 2. * impact.simulation.plates()[i]->count_bonds() /
           (1. - plates[i].broken_share);
    EXPECT_EQ(maps[i].plate, static_cast<int>(i) + 1);
    EXPECT_EQ(maps[i].n_x, 30);
    EXPECT_EQ(maps[i].n_y, 8); // half of 16
    EXPECT_TRUE(maps[i].mirrored);
    EXPECT_EQ(maps[i].spacing, 1e-3);
    if (rank != 0)
      continue;
    for (const auto &[map, area] :
         {std::pair{maps[i].front, plates[i].front_area}, {maps[i].rear, plates[i].rear_area}})
    {
      int n_damaged = 0;
      for (const float damage : map)
        n_damaged += damage > DamageReport::damaged_share;
      EXPECT_NEAR(area, 2. * n_damaged * 1e-6, 1e-15); // a square millimetre each, both halves
    }
  }
  EXPECT_GT(lost, 10000.);
  EXPECT_NEAR(sum, lost, 1e-9 * lost);
}

TEST(DamageReport, HolesHaveNoValueAndCracksCountFromTheStart)
{
  for (const bool half : {false, true})
  {
    Scene scene                     = small_scene(); // 30 x 16 x 9 points
    scene.symmetric                 = half;
    scene.plates[0].cutouts.holes   = {{20e-3, 0., 2.9e-3}}; // 2 x 2 columns
    scene.plates[0].cutouts.notches = {{5e-3, 6e-3, -2e-3, 2e-3, 0., 3e-3}};
    const double sound              = Simulation(MPI_COMM_SELF, scene).n_bonds();
    scene.plates[0].cutouts.cracks  = {{0, 12e-3, -8e-3, 8e-3, 0., 9e-3}};
    const Impact impact(MPI_COMM_WORLD, scene, 0);
    EXPECT_NEAR(impact.report.plates()[0].broken_share, 1. - impact.simulation.n_bonds() / sound,
                1e-14);
    EXPECT_GT(impact.report.plates()[0].front_area, 0.);
    const auto map = impact.report.maps()[0];
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    for (int x = 0; rank == 0 && x < 30; ++x)
      for (int y = 0; y < map.n_y; ++y)
      {
        const int from_middle = half ? y : y < 8 ? 7 - y : y - 8;
        const bool hole       = (x == 19 || x == 20) && from_middle == 0,
                   notch      = x == 5 && from_middle < 2;
        const std::size_t at  = static_cast<std::size_t>(x) * map.n_y + y;
        EXPECT_EQ(std::isnan(map.front[at]), hole || notch) << x << ' ' << y;
        EXPECT_EQ(std::isnan(map.rear[at]), hole) << x << ' ' << y;
        EXPECT_EQ(std::isnan(map.mean[at]), hole) << x << ' ' << y;
        EXPECT_EQ(map.mean[at] > 0.3F, x == 11 || x == 12) << x << ' ' << y;
      }
  }
}

TEST(DamageReport, IsTheSameOnAnyNumberOfRanks)
{
  const Impact all(MPI_COMM_WORLD, small_scene(), 150), one(MPI_COMM_SELF, small_scene(), 150);
  const auto a = all.report.plates().at(0), b = one.report.plates().at(0);
  EXPECT_EQ(a.broken_share, b.broken_share);
  EXPECT_EQ(a.front_area, b.front_area);
  EXPECT_EQ(a.rear_area, b.rear_area);
  EXPECT_GT(a.front_area, 0.);
  const auto maps = all.report.maps(), alone = one.report.maps();
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
  {
    EXPECT_EQ(maps.at(0).mean, alone.at(0).mean);
  }
}
} // namespace
} // namespace ricochet::tests
