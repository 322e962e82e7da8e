// SPDX-License-Identifier: LGPL-2.1-or-later
// A simulation that is saved, built anew and restored goes on as if nothing had happened: to the
// last bit, on any number of ranks.
#include "ricochet/output/checkpoint_file.h"
#include "ricochet/simulation/history_record.h"
#include "support/coupled_scene.h"
#include "support/scratch_directory.h"

namespace ricochet::tests
{
namespace
{
using Rows = std::vector<std::vector<double>>;

/// Steps, with a record of all that a history has every so often.
Rows go_on(Simulation &simulation, const int n_steps)
{
  Rows rows;
  for (int i = 0; i < n_steps; ++i)
  {
    const bool records = simulation.step() % 10 == 0;
    simulation.compute_forces(records);
    if (records)
    {
      const auto totals = totals_of(simulation);
      rows.push_back(history_record({simulation, totals}));
    }
    simulation.advance();
  }
  return rows;
}

int different(const Rows &one, const Rows &other)
{
  EXPECT_EQ(one.size(), other.size());
  int n = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    for (std::size_t k = 0; k < one[i].size(); ++k)
      if (one[i][k] != other[i][k])
      {
        ++n;
        ADD_FAILURE() << "row " << i << ", " << history_columns()[k].name << ": " << one[i][k]
                      << " and " << other[i][k];
      }
  return n;
}

constexpr int n_before = 75, n_after = 66;

/// Saved on all ranks; restored on all, and on one alone.
void expect_no_difference(const Scene &scene)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "state";
  Rows uninterrupted;
  {
    Simulation simulation(MPI_COMM_WORLD, scene);
    go_on(simulation, n_before);
    CheckpointWriter archive(MPI_COMM_WORLD);
    simulation.exchange_state(archive);
    archive.save(path);
    uninterrupted = go_on(simulation, n_after);
    EXPECT_GT(simulation.broken_bonds(), 1000.) << "too few for a hard test";
  }
  const auto resumed_on = [&](const MPI_Comm communicator)
  {
    Simulation simulation(communicator, scene);
    CheckpointReader archive(communicator, path);
    simulation.exchange_state(archive);
    return go_on(simulation, n_after);
  };
  EXPECT_EQ(different(resumed_on(MPI_COMM_WORLD), uninterrupted), 0) << n_ranks() << " ranks";
  if (n_ranks() > 1 && rank() == 0)
  {
    EXPECT_EQ(different(resumed_on(MPI_COMM_SELF), uninterrupted), 0) << "one rank";
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

Scene flowing(Scene scene)
{
  scene.materials[0].flow = {66.78e6, 0.06933, 0.223};
  return scene;
}

Scene growing(Scene scene)
{
  scene.zone.adaptive = scene.zone.grows_everywhere = true;
  scene.plates[0].zone_boxes                        = {{4e-3, 14e-3, -5e-3, 5e-3}};
  return scene;
}

TEST(Checkpoint, OfFlowingPlatesWithFriction)
{
  Scene scene                   = flowing(two_plates());
  scene.contact.debris_friction = 1.;
  expect_no_difference(scene);
}

TEST(Checkpoint, OfTwoProjectilesOnJoinedPlates)
{
  Scene scene                   = two_plates();
  scene.plates[1].joint_tension = 40e6;
  scene.further_shots.push_back({scene.projectile, scene.impact});
  scene.further_shots[0].impact.entry_x += 9e-3;
  expect_no_difference(scene);
}

TEST(Checkpoint, OfAHalfModelThatRelaxes)
{
  expect_no_difference(symmetric(relaxing(small_scene(), HistoryPrecision::single_precision)));
}

TEST(Checkpoint, OfAProjectileOfElements)
{
  expect_no_difference(symmetric(deformable(small_scene())));
}

TEST(Checkpoint, OfAModalProjectile)
{
  expect_no_difference(symmetric(modal(small_scene())));
}

TEST(Checkpoint, OfAProjectileOfPointsAndElements)
{
  expect_no_difference(symmetric(peridynamic_nose(small_scene())));
}

TEST(Checkpoint, OfAClampedCoupledPlate)
{
  Scene scene                   = symmetric(coupled_scene());
  scene.plates[0].clamped_sides = ClampedSides::ends;
  expect_no_difference(scene);
}

TEST(Checkpoint, OfACoupledPlateWithAbsorbingEdges)
{
  Scene scene                     = coupled_scene();
  scene.plates[0].absorbing_edges = true;
  scene.plates[0].zone_boxes      = {{6e-3, 28e-3, -6e-3, 6e-3}};
  expect_no_difference(scene);
}

TEST(Checkpoint, OfAZoneThatGrows)
{
  expect_no_difference(growing(flowing(coupled_scene())));
}

TEST(Checkpoint, OfACoupledPlateThatRelaxes)
{
  expect_no_difference(relaxing(coupled_scene(), HistoryPrecision::double_precision));
}

TEST(Checkpoint, OfAZoneThatGrowsInWhatRelaxes)
{
  expect_no_difference(
      growing(symmetric(relaxing(coupled_scene(), HistoryPrecision::double_precision))));
}

TEST(Checkpoint, AnotherStateGoesOnOtherwise)
{
  const ScratchDirectory folder;
  const auto path   = folder.path() / "state";
  const Scene scene = symmetric(small_scene());
  Simulation one(MPI_COMM_WORLD, scene);
  go_on(one, 40);
  CheckpointWriter archive(MPI_COMM_WORLD);
  one.exchange_state(archive);
  archive.save(path);
  Simulation other(MPI_COMM_WORLD, scene);
  CheckpointReader saved(MPI_COMM_WORLD, path);
  other.exchange_state(saved);
  EXPECT_EQ(other.step(), 40);
  go_on(one, 1);
  EXPECT_NE(go_on(one, 10), go_on(other, 10));
}
} // namespace
} // namespace ricochet::tests
