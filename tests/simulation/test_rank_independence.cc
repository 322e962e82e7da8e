// SPDX-License-Identifier: LGPL-2.1-or-later
// The same impact on one rank and on all: not nearly, but exactly the same numbers.
#include "ricochet/base/exceptions.h"
#include "support/small_scene.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
int size_of(const MPI_Comm communicator)
{
  int size;
  MPI_Comm_size(communicator, &size);
  return size;
}

/// Everything a history file would hold, every 20 steps.
std::vector<double> history(const MPI_Comm communicator, const Scene &scene, const int n_steps)
{
  Simulation simulation(communicator, scene);
  std::vector<double> rows{simulation.dt()};
  const auto add = [&](const Vector3 &v) { rows.insert(rows.end(), v.data(), v.data() + 3); };
  for (int i = 0; i <= n_steps; ++i)
  {
    simulation.compute_forces(/*energy=*/true);
    if (i % 20 == 0)
    {
      for (std::size_t k = 0; k < simulation.n_projectiles(); ++k)
      {
        const auto &motion = simulation.projectile(k).motion();
        for (const auto &v : {motion.position, motion.velocity, motion.spin})
          add(v);
        rows.insert(rows.end(), motion.orientation.coeffs().data(),
                    motion.orientation.coeffs().data() + 4);
      }
      const auto e = simulation.energies();
      rows.insert(rows.end(), {e.projectile, e.kinetic, e.strain, e.contact, e.debris, e.friction,
                               e.fracture, e.initial, e.viscous, e.debris_friction});
      const auto m = simulation.momenta();
      add(m.linear);
      add(m.angular);
      const auto &r = simulation.reaction();
      for (const auto &v : {r.normal, r.friction, r.shank, r.moment})
        add(v);
      rows.insert(rows.end(), {r.energy, r.deepest, r.n_touching, simulation.broken_bonds(),
                               simulation.n_bonds(), simulation.n_points()});
    }
    simulation.advance();
  }
  return rows;
}

void expect_the_same_on_any_number_of_ranks(const Scene &scene)
{
  const int n_steps       = 140;
  std::vector<double> all = history(MPI_COMM_WORLD, scene, n_steps), one(all.size());
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    one = history(MPI_COMM_SELF, scene, n_steps);
  MPI_Bcast(one.data(), static_cast<int>(one.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  ASSERT_EQ(all.size(), one.size());
  int n_different = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    n_different += all[i] != one[i];
  verify_at_most("V28", "ranks: numbers of the history that differ from one rank", n_different, 0.);
  EXPECT_GT(all[all.size() - 3], 10000.) << "too few broken bonds for a hard test";
}

TEST(RankIndependence, FullModelIsExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(small_scene());
}

TEST(RankIndependence, HalfModelIsExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(symmetric(small_scene()));
}

TEST(RankIndependence, TwoPlatesWithFrictionAreExactlyTheSame)
{
  Scene scene                   = two_plates();
  scene.contact.debris_friction = 1.;
  expect_the_same_on_any_number_of_ranks(scene);
}

TEST(RankIndependence, TwoHalfPlatesAreExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(symmetric(two_plates()));
}

TEST(RankIndependence, JoinedHalfPlatesAreExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(joined(symmetric(two_plates())));
}

TEST(RankIndependence, BondBasedLawIsExactlyTheSame)
{
  Scene scene                      = symmetric(small_scene());
  scene.materials[0].bond_model    = "microelastic brittle";
  scene.materials[0].shear_modulus = 0.6 * scene.materials[0].bulk_modulus; // nu = 1/4
  expect_the_same_on_any_number_of_ranks(scene);
}

TEST(RankIndependence, RelaxingPlateIsExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(
      symmetric(relaxing(small_scene(), HistoryPrecision::single_precision)));
}

TEST(RankIndependence, TwoRelaxingPlatesWithDoubleHistoryAreExactlyTheSame)
{
  expect_the_same_on_any_number_of_ranks(
      relaxing(two_plates(), HistoryPrecision::double_precision));
}

TEST(RankIndependence, PlatesWithHolesAndCracksAreExactlyTheSame)
{
  Scene scene                     = symmetric(small_scene());
  scene.plates[0].cutouts.holes   = {{16e-3, 0., 4e-3}};
  scene.plates[0].cutouts.notches = {{20e-3, 21e-3, -5e-3, 5e-3, 0., 4e-3}};
  scene.plates[0].cutouts.cracks  = {{0, 10.5e-3, -3e-3, 3e-3, 0., 5e-3},
                                     {1, 0., 22e-3, 29e-3, 2e-3, 9e-3}};
  expect_the_same_on_any_number_of_ranks(scene);
}

TEST(RankIndependence, TwoProjectilesAreExactlyTheSame)
{
  Scene scene = symmetric(small_scene());
  scene.further_shots.push_back({deformable(scene).projectile, scene.impact});
  scene.further_shots[0].impact.entry_x   = 20e-3;
  scene.further_shots[0].impact.clearance = 2e-3;
  expect_the_same_on_any_number_of_ranks(scene);
}

TEST(RankIndependence, PlateTooShortForTheRanksIsRefused)
{
  Scene scene            = small_scene();
  scene.plates[0].length = 3e-3; // three planes; each rank needs the two that the cone reaches
  scene.impact.entry_x   = 1.5e-3;
  if (size_of(MPI_COMM_WORLD) == 1)
    EXPECT_NO_THROW(Simulation(MPI_COMM_WORLD, scene));
  else
    EXPECT_THROW(Simulation(MPI_COMM_WORLD, scene), InputError);
}

TEST(RankIndependence, ErrorOnOneRankIsThrownOnAll)
{
  Simulation simulation(MPI_COMM_WORLD, small_scene());
  simulation.compute_forces(false);
  EXPECT_NO_THROW(simulation.check_finite());
  const auto &l = simulation.plates()[0]->lattice();
  const auto p  = l.index(29, 4, 5); // lives on the last rank
  if (l.first_plane() + l.n_planes() == 30)
    simulation.plates()[0]->state().arrays.force[0][p] = std::nan("");
  EXPECT_THROW(simulation.check_finite(), RunError);
}
} // namespace
} // namespace ricochet::tests
