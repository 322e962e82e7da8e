// SPDX-License-Identifier: LGPL-2.1-or-later
// Several projectiles in one scene.
#include "ricochet/base/exceptions.h"
#include "ricochet/simulation/history_record.h"
#include "ricochet/simulation/plate_zone.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
/// The same with one more that comes down here.
Scene with_another(Scene scene, const double entry_x, const double entry_y)
{
  Shot another{scene.projectile, scene.impact};
  another.impact.entry_x = entry_x;
  another.impact.entry_y = entry_y;
  scene.further_shots.push_back(another);
  return scene;
}

/// Two that do not know of each other for 40 mm: 14 us at 2.8 mm/us, the speed of P waves in PMMA.
Scene far_apart()
{
  Scene scene               = small_scene();
  scene.plates[0].length    = 70e-3;
  scene.plates[0].thickness = 5e-3;
  return with_another(scene, 48e-3, 2e-3);
}

std::vector<double> numbers_of(const Simulation &simulation, const std::size_t i)
{
  const auto &motion = simulation.projectile(i).motion();
  const auto &record = simulation.reaction(i);
  std::vector<double> numbers{record.n_touching, record.energy};
  for (const Vector3 &v : {motion.position, motion.velocity, motion.spin, record.normal,
                           record.friction, record.shank, record.moment})
    numbers.insert(numbers.end(), v.data(), v.data() + 3);
  return numbers;
}

/// Steps until the time; the forces are then those of it.
void run_until(Simulation &simulation, const double time)
{
  for (simulation.compute_forces(false); simulation.time() < time; simulation.compute_forces(false))
    simulation.advance();
}

TEST(SeveralProjectiles, FarApartEachFliesAsIfAloneUntilWavesMeet)
{
  const Scene scene = far_apart();
  Simulation both(MPI_COMM_WORLD, scene);
  Simulation first(MPI_COMM_WORLD, scene.with_only(0)), second(MPI_COMM_WORLD, scene.with_only(1));
  ASSERT_EQ(both.n_projectiles(), 2u);
  ASSERT_EQ(first.n_projectiles(), 1u);
  ASSERT_EQ(both.dt(), first.dt());
  for (const double time : {3e-6, 6e-6})
  {
    for (auto *const simulation : {&both, &first, &second})
      run_until(*simulation, time);
    EXPECT_EQ(numbers_of(both, 0), numbers_of(first, 0)) << time;
    EXPECT_EQ(numbers_of(both, 1), numbers_of(second, 0)) << time;
    EXPECT_EQ(both.broken_bonds(), first.broken_bonds() + second.broken_bonds());
  }
  EXPECT_GT(both.reaction(0).n_touching, 0.);
  EXPECT_GT(both.reaction(1).n_touching, 0.);
  EXPECT_GT(first.broken_bonds(), 100.);
  // Not the waves yet, but their forerunners through the lattice, three spacings a step.
  run_until(both, 9e-6);
  run_until(first, 9e-6);
  EXPECT_LT((both.projectile(0).motion().velocity - first.projectile(0).motion().velocity).norm(),
            1e-10 * 300.);
  // Then they do.
  run_until(both, 40e-6);
  run_until(first, 40e-6);
  EXPECT_NE(numbers_of(both, 0), numbers_of(first, 0));
}

TEST(SeveralProjectiles, MirroredOnesMoveMirrored)
{
  Scene scene           = small_scene();
  scene.plates[0].width = 24e-3;
  scene.impact.entry_y  = -6e-3;
  scene                 = with_another(scene, scene.impact.entry_x, 6e-3);
  const double flip[]   = {1., -1., 1.};
  Simulation simulation(MPI_COMM_WORLD, scene);
  for (int step = 0; step < 80; ++step)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  EXPECT_GT(simulation.broken_bonds(), 1000.);
  const auto &a = simulation.projectile(0).motion(), &b = simulation.projectile(1).motion();
  // Sums over bonds run in another order on the mirrored side: rounding, 1e-16 of the stresses,
  // which 80 steps of fracture have let grow.
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(a.position[d], flip[d] * b.position[d], 1e-12); // of 1e-2 m
    EXPECT_NEAR(a.velocity[d], flip[d] * b.velocity[d], 1e-8);  // of 300 m/s
    EXPECT_NEAR(a.spin[d], -flip[d] * b.spin[d], 1e-5);         // of 1e3 rad/s
  }
  EXPECT_GT((a.velocity - Vector3(300. * std::cos(M_PI / 6.), 0., -150.)).norm(), 1.);
}

TEST(SeveralProjectiles, BalancesCountAllOfThem)
{
  // One that deforms, one that is rigid, one that is driven.
  Scene scene = with_another(with_another(small_scene(), 20e-3, -4e-3), 14e-3, 5e-3);
  scene.further_shots[0].projectile        = deformable(scene).projectile;
  scene.further_shots[1].projectile.driven = true;
  scene.plates[0].width                    = 24e-3;
  scene.impact.entry_y                     = -1e-3;
  Simulation simulation(MPI_COMM_WORLD, scene);
  EXPECT_LT(simulation.time_step_info().projectile_dt, 1.) << "the elements' step";
  simulation.compute_forces(true);
  const auto start = simulation.momenta();
  const double one = 0.5 * 0.8e-3 * 300. * 300.;
  EXPECT_NEAR(simulation.energies().initial, 3. * one, 1e-9 * one);
  EXPECT_NEAR(simulation.energies().projectile, 3. * one, 1e-9 * one);
  Vector3 momentum = Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i)
    momentum += 0.8e-3 * simulation.projectile(i).motion().velocity;
  EXPECT_LT((start.linear - momentum).norm(), 1e-12 * momentum.norm());
  while (simulation.time() < 30e-6)
  {
    simulation.advance();
    simulation.compute_forces(true);
  }
  const auto e = simulation.energies();
  EXPECT_GT(e.elastic, 0.);
  EXPECT_GT(e.drive, 0.);
  EXPECT_GT(e.friction, 0.);
  EXPECT_EQ(simulation.projectile(2).motion().velocity.norm(),
            Vector3(300. * std::cos(M_PI / 6.), 0., -300. * std::sin(M_PI / 6.)).norm());
  // What a small scene of one projectile keeps, see Simulation.EnergyIsConserved.
  EXPECT_LT(std::abs(e.residual()), 0.01 * (e.initial + e.drive));
  const auto end = simulation.momenta();
  EXPECT_LT((end.linear - start.linear).norm(), 1e-11 * start.linear.norm());
  EXPECT_LT((end.angular - start.angular).norm(), 1e-11 * start.angular.norm());
}

TEST(SeveralProjectiles, HistoryAppendsColumnsOfTheOthers)
{
  Simulation simulation(MPI_COMM_WORLD, far_apart());
  run_until(simulation, 3e-6);
  simulation.compute_forces(true);
  const Totals totals = totals_of(simulation);
  const Moment moment{simulation, totals};
  const auto columns = history_columns(2), of_one = history_columns();
  const auto record = history_record(moment);
  ASSERT_EQ(record.size(), columns.size());
  ASSERT_GT(columns.size(), of_one.size());
  std::map<std::string, double> value;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const std::string &name = columns[i].name;
    EXPECT_EQ(record[i], columns[i].value(moment)) << name;
    EXPECT_EQ(i < of_one.size() ? of_one[i].name : " 2",
              i < of_one.size() ? name : name.substr(name.size() - 2));
    value[name] = record[i];
  }
  EXPECT_EQ(value.at("x 2"), simulation.present_motion(1).position.x() / 1e-3);
  EXPECT_EQ(value.at("force z 2"), simulation.reaction(1).force().z() / 1e3);
  EXPECT_EQ(value.at("tip depth 2"), -simulation.projectile(1).bounding_box().first.z() / 1e-3);
}

TEST(SeveralProjectiles, OneThatStartsInAPlateIsNamed)
{
  Scene scene                             = far_apart();
  scene.further_shots[0].impact.clearance = -1e-3;
  try
  {
    Simulation(MPI_COMM_WORLD, scene);
    FAIL() << "it starts inside the plate";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("Projectile 2 starts inside plate 1"), std::string::npos) << message;
    EXPECT_NE(message.find("'Impact 2/Clearance'"), std::string::npos) << message;
  }
}

TEST(SeveralProjectiles, AutomaticZonesHoldTheCorridorsOfAll)
{
  Scene scene                  = small_scene();
  scene.plates[0].length       = 240e-3;
  scene.plates[0].width        = 60e-3;
  scene.plates[0].thickness    = 8e-3;
  scene.impact.incidence_angle = M_PI / 2.;
  scene.impact.entry_x         = 40e-3;
  scene.zone.kind              = ZoneKind::automatic;
  scene                        = with_another(scene, 190e-3, 0.);
  for (const bool adaptive : {false, true})
  {
    scene.zone.adaptive = adaptive;
    const auto zone_of  = [](const Scene &given)
    {
      const auto &plate = given.plates[0];
      const Lattice::Box box{{0., -30e-3, -8e-3}, 1e-3, {240, 60, 8}, false};
      return plate_zone(given, plate, box,
                        make_stencil(1e-3, plate.horizon_ratio, plate.influence_function));
    };
    const auto both = zone_of(scene), first = zone_of(scene.with_only(0)),
               second = zone_of(scene.with_only(1));
    int n_first = 0, n_second = 0;
    both.zone->for_each_cell(
        [&](const Zone::Cell &cell)
        {
          const bool in_first = first.zone->is_free(cell), in_second = second.zone->is_free(cell);
          EXPECT_EQ(both.zone->is_free(cell), in_first || in_second);
          n_first += in_first;
          n_second += in_second;
        });
    EXPECT_GT(n_first, 0);
    EXPECT_EQ(n_first, n_second);
    EXPECT_LT(n_first + n_second,
              both.zone->n_cells()[0] * both.zone->n_cells()[1] * both.zone->n_cells()[2]);
  }
}
} // namespace
} // namespace ricochet::tests
