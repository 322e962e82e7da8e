// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/run_warnings.h"

#include "support/coupled_scene.h"
#include "support/scratch_directory.h"

namespace ricochet::tests
{
namespace
{
/// What a scene's first steps warn about, on this rank.
std::string warnings_of(const Scene &scene, const int n_steps, RunWarnings &warnings)
{
  Simulation simulation(MPI_COMM_WORLD, scene);
  testing::internal::CaptureStderr();
  for (int step = 0; step < n_steps; ++step)
  {
    simulation.compute_forces(true);
    warnings.update(simulation);
    const Totals totals = totals_of(simulation);
    warnings.update({simulation, totals});
    simulation.advance();
  }
  return testing::internal::GetCapturedStderr();
}

std::size_t count(const std::string &text, const std::string &part)
{
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

TEST(RunWarnings, SoundContactHasNone)
{
  RunWarnings warnings(MPI_COMM_WORLD);
  EXPECT_EQ(warnings_of(two_plates(), 60, warnings), "");
  EXPECT_GT(warnings.deepest(), 0.);
  EXPECT_LT(warnings.deepest(), 0.5);
  EXPECT_LT(warnings.on_elements_since(), 0.);
}

TEST(RunWarnings, ContactThatIsTooSoftIsNamedOnce)
{
  Scene scene                    = two_plates();
  scene.contact.stiffness_factor = 0.002;
  RunWarnings warnings(MPI_COMM_WORLD);
  const std::string text = warnings_of(scene, 100, warnings);
  EXPECT_GT(warnings.deepest(), 0.5);
  EXPECT_EQ(count(text, "contact is too soft"), rank() == 0 ? 1u : 0u) << text;
}

TEST(RunWarnings, ElementsUnderTheProjectileAreNamedOnce)
{
  Scene scene                = coupled_scene();
  scene.plates[0].zone_boxes = {{22e-3, 38e-3, -8e-3, 8e-3}}; // far behind the entry point
  RunWarnings warnings(MPI_COMM_WORLD);
  const std::string text = warnings_of(scene, 30, warnings);
  EXPECT_GT(warnings.on_elements_since(), 0.);
  EXPECT_EQ(count(text, "touches finite elements"), rank() == 0 ? 1u : 0u) << text;
}

TEST(RunWarnings, ProjectilesThatMeetAreNamedOnce)
{
  Scene scene = two_plates();
  scene.further_shots.push_back({scene.projectile, scene.impact});
  for (const double x : {22e-3, 12e-3}) // 14 mm and 4 mm behind the first, of 10 mm at 30 degrees
  {
    scene.further_shots[0].impact.entry_x = x;
    RunWarnings warnings(MPI_COMM_WORLD);
    const std::string text = warnings_of(scene, 3, warnings);
    EXPECT_EQ(count(text, "boxes around projectiles 1 and 2 overlap"),
              rank() == 0 && x < 15e-3 ? 1u : 0u)
        << text;
  }
}

TEST(RunWarnings, LargeHourglassEnergyIsNamedOnce)
{
  // The projectile pushes at the nodes of elements a quarter of the thickness large.
  Scene scene     = coupled_scene();
  scene.zone.kind = ZoneKind::none;
  RunWarnings warnings(MPI_COMM_WORLD);
  const std::string text = warnings_of(scene, 60, warnings);
  EXPECT_GT(warnings.hourglass().share, HourglassWatch::most);
  EXPECT_GT(warnings.hourglass().time, 0.);
  EXPECT_EQ(count(text, "of the energy in the elements of plate 1"), rank() == 0 ? 1u : 0u) << text;

  scene.zone.full_quadrature = true; // has no such modes
  RunWarnings full(MPI_COMM_WORLD);
  EXPECT_EQ(warnings_of(scene, 60, full), "");
}
} // namespace
} // namespace ricochet::tests
