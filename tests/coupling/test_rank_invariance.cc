// SPDX-License-Identifier: LGPL-2.1-or-later
// V24: the same coupled impact on one rank and on all: not nearly, but exactly the same numbers.
#include "ricochet/simulation/history_record.h"
#include "support/coupled_scene.h"
#include "support/verification.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace ricochet::tests
{
namespace
{
struct Course
{
  std::vector<double> numbers; // the time step, then every column of the history of each row
  long redistributions = 0;
};

Course run(const MPI_Comm communicator, const Scene &scene)
{
  constexpr int n_steps = 100, steps_per_row = 5;
  Simulation simulation(communicator, scene);
  Course course;
  course.numbers.push_back(simulation.dt());
  for (int step = 0; step <= n_steps; ++step)
  {
    const bool records = step % steps_per_row == 0;
    simulation.compute_forces(records);
    if (records)
    {
      const auto totals = totals_of(simulation);
      const auto row    = history_record({simulation, totals});
      course.numbers.insert(course.numbers.end(), row.begin(), row.end());
    }
    simulation.advance();
  }
  EXPECT_GT(simulation.broken_bonds(), 1000.) << "too few for a hard test";
  course.redistributions = simulation.coupled_plate(0)->adaptive_zone().n_redistributions();
  return course;
}

int different(const Course &one, const Course &other)
{
  EXPECT_EQ(one.numbers.size(), other.numbers.size());
  int n = 0;
  for (std::size_t i = 0; i < std::min(one.numbers.size(), other.numbers.size()); ++i)
    n += one.numbers[i] != other.numbers[i];
  return n;
}

/// Returns how often the points were shared anew.
long expect_the_same_on_all_ranks(const Scene &scene)
{
  const Course all = run(MPI_COMM_WORLD, scene), one = run(MPI_COMM_SELF, scene);
  verify_at_most("V24", "numbers of the history that differ from one rank", different(all, one),
                 0.);
  return all.redistributions;
}

void expect_redistributions(const long n)
{
  int n_ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  EXPECT_EQ(n > 0, n_ranks > 1);
}

Scene relaxing(Scene scene)
{
  for (auto &material : scene.materials)
  {
    material.relaxation        = {{0.3, 20e-6}, {0.4, 3e-6}};
    material.history_precision = HistoryPrecision::double_precision;
  }
  return scene;
}

Scene growing(Scene scene)
{
  scene.zone.adaptive = scene.zone.grows_everywhere = true;
  scene.plates[0].zone_boxes                        = {{4e-3, 16e-3, -6e-3, 6e-3}};
  return scene;
}

/// Elements become larger away from the zone, with hanging nodes between.
Scene coarsened(Scene scene)
{
  scene.plates[0].length       = 64e-3;
  scene.plates[0].width        = 48e-3;
  scene.zone.coarsening_levels = 1;
  scene.plates[0].zone_boxes   = {{2e-3, 18e-3, -6e-3, 6e-3}};
  return scene;
}

TEST(V24Ranks, ThereAreAsManyAsWereAskedFor)
{
  // Started without a launcher, or with one that is not Open MPI's, nothing was asked for.
  const char *const asked = std::getenv("OMPI_COMM_WORLD_SIZE");
  int n_ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  EXPECT_EQ(n_ranks, asked == nullptr ? 1 : std::atoi(asked));
}

TEST(V24Ranks, FixedZoneIsTheSame)
{
  expect_the_same_on_all_ranks(coupled_scene());
}

TEST(V24Ranks, MirroredFixedZoneIsTheSame)
{
  expect_the_same_on_all_ranks(symmetric(coupled_scene()));
}

TEST(V24Ranks, LargerElementsWithHangingNodesAreTheSame)
{
  const Scene scene = coarsened(symmetric(coupled_scene()));
  const Simulation simulation(MPI_COMM_WORLD, scene);
  auto n =
      static_cast<int>(simulation.coupled_plate(0)->elements().mesh().hanging_nodes().node.size());
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_GT(n, 100);
  expect_the_same_on_all_ranks(scene);
}

TEST(V24Ranks, OtherKindsOfCouplingAndFullQuadratureAreTheSame)
{
  for (const auto method : {CouplingMethod::energy_blend, CouplingMethod::force_blend})
  {
    Scene scene                = symmetric(coupled_scene());
    scene.zone.coupling.method = method;
    scene.zone.full_quadrature = true;
    expect_the_same_on_all_ranks(scene);
  }
}

TEST(V24Ranks, ClampedEdgesAreTheSame)
{
  Scene scene                   = symmetric(coupled_scene());
  scene.plates[0].clamped_sides = ClampedSides::all;
  expect_the_same_on_all_ranks(scene);
}

TEST(V24Ranks, RelaxingPlateIsTheSame)
{
  expect_the_same_on_all_ranks(relaxing(coupled_scene()));
}

TEST(V24Ranks, RelaxingPlateWithAGrowingZoneIsTheSame)
{
  expect_redistributions(expect_the_same_on_all_ranks(growing(relaxing(coupled_scene()))));
}

TEST(V24Ranks, EdgesThatDoNotReflectAreTheSame)
{
  Scene scene                     = coupled_scene();
  scene.plates[0].absorbing_edges = true;
  scene.plates[0].zone_boxes      = {{6e-3, 28e-3, -6e-3, 6e-3}};
  expect_the_same_on_all_ranks(scene);
}

TEST(V24Ranks, GrowingZoneWithAHoleAndACrackIsTheSame)
{
  Scene scene                    = growing(coupled_scene());
  scene.plates[0].length         = 60e-3;
  scene.plates[0].cutouts.holes  = {{20e-3, 1e-3, 4e-3}};
  scene.plates[0].cutouts.cracks = {{0, 13e-3, -3e-3, 4e-3, 0., 4e-3}};
  expect_redistributions(expect_the_same_on_all_ranks(scene));
}

TEST(V24Ranks, GrowingZoneIsTheSame)
{
  expect_redistributions(expect_the_same_on_all_ranks(growing(coupled_scene())));
}

TEST(V24Ranks, MirroredGrowingZoneIsTheSame)
{
  expect_redistributions(expect_the_same_on_all_ranks(growing(symmetric(coupled_scene()))));
}

TEST(V24Ranks, ProjectileOfElementsIsTheSame)
{
  expect_the_same_on_all_ranks(symmetric(deformable(coupled_scene())));
}

TEST(V24Ranks, AnotherTimeStepGivesOtherNumbers)
{
  Scene scene              = symmetric(coupled_scene());
  const Course one         = run(MPI_COMM_WORLD, scene);
  scene.time.safety_factor = 0.999 * scene.time.safety_factor;
  verify_at_least("V24", "the same if the time step is a thousandth shorter",
                  different(one, run(MPI_COMM_WORLD, scene)), 100.);
}
} // namespace
} // namespace ricochet::tests
