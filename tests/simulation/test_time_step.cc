// SPDX-License-Identifier: LGPL-2.1-or-later
// The step of a scene: 'Safety factor' is in units of the largest stable one, so 1 is stable.
#include "ricochet/coupling/dispersion.h"
#include "ricochet/scene/scene_reader.h"
#include "support/coupled_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
Scene soft_contact()
{
  return read_scene(
      ParameterFile(std::string(RICOCHET_SOURCE_DIR) + "/tests/cases/soft_contact.prm"));
}

/// The same with points around the entry point only.
Scene soft_contact_with_elements()
{
  Scene scene                = soft_contact();
  scene.zone.kind            = ZoneKind::boxes;
  scene.plates[0].zone_boxes = {{12e-3, 36e-3, -12e-3, 12e-3}};
  return scene;
}

/// Runs to the end and expects the energy to stay what it is.
void expect_stable(const Scene &scene)
{
  ASSERT_EQ(scene.time.safety_factor, 1.);
  Simulation simulation(MPI_COMM_SELF, scene);
  double worst = 0.;
  while (simulation.time() < scene.time.end_time)
  {
    const bool due = simulation.step() % 10 == 0;
    simulation.compute_forces(due);
    if (due)
      worst = std::max(worst, std::abs(simulation.energies().residual()));
    simulation.advance();
  }
  // Seen are 4e-5, where points touch and let go between two steps; a mode beyond the limit holds
  // the whole energy after a hundred steps.
  EXPECT_LT(worst, 2e-4 * simulation.energies().initial);
  EXPECT_GT(simulation.projectile().motion().velocity.z(), 0.8 * scene.impact.speed); // has bounced
}

TEST(TimeStep, AFactorOfOneIsStableWithPoints)
{
  // Were contact stiffer, its share of the squared frequency would hide an error of the points'.
  ASSERT_LT(Simulation(MPI_COMM_SELF, soft_contact()).time_step_info().contact_share, 0.02);
  expect_stable(soft_contact());
}

TEST(TimeStep, AFactorOfOneIsStableWithElementsAroundPoints)
{
  expect_stable(soft_contact_with_elements());
}

TEST(TimeStep, AFactorOfOneIsStableWithAProjectileOfElements)
{
  Scene scene     = deformable(soft_contact_with_elements());
  const auto info = Simulation(MPI_COMM_SELF, scene).time_step_info();
  ASSERT_LT(info.projectile_dt, info.plates_dt); // steel is stiffer
  expect_stable(scene);
  scene.contact.stiffness_factor = 1.; // as in most scenes
  expect_stable(scene);
}

TEST(TimeStep, AZoneThatGrowsMayBecomeALattice)
{
  // A zone so small at the start that the slack of its bound does not reach the lattice's
  // frequency.
  Scene scene                      = coupled_scene();
  scene.zone.kind                  = ZoneKind::automatic;
  scene.zone.adaptive              = true;
  scene.projectile.shape.diameter  = 2e-3;
  scene.plates[0].horizon_ratio    = 2.;
  // nu = 1/8: with a larger one elements have the highest frequency.
  scene.materials[0].shear_modulus = scene.materials[0].bulk_modulus;
  Simulation simulation(MPI_COMM_SELF, scene);
  const double limit   = predicted_time_step(*simulation.plates()[0]).points;
  const double lattice = 4. / (limit * limit);
  EXPECT_LT(frequency_bound(MPI_COMM_SELF, *simulation.coupled_plate(0)).squared_frequency,
            0.99 * lattice);
  EXPECT_NEAR(simulation.frequencies()[0].squared_frequency, lattice, 1e-15 * lattice); // rounding
}
} // namespace
} // namespace ricochet::tests
