// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole impacts with a projectile that has its lowest eigenmodes.
#include "projectiles/modal_projectile.h"
#include "ricochet/base/exceptions.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
/// A longer projectile than that of the small scene, or none of its modes would be slow enough.
Scene slender(Scene scene)
{
  scene.projectile.shape.length = 24e-3;
  scene.projectile.mass         = 2.2e-3;
  return modal(scene);
}

int n_modes(const Simulation &simulation)
{
  return dynamic_cast<const ModalProjectile &>(simulation.projectile()).elastic().n_modes();
}

TEST(ModalProjectile, EnergyAndMomentaBalance)
{
  for (Scene scene : {slender(small_scene()), slender(symmetric(two_plates()))})
    for (const int n : {0, 8})
    {
      scene.projectile.modes = n;
      Simulation simulation(MPI_COMM_SELF, scene);
      const auto info = simulation.time_step_info();
      if (n == 0) // automatic
      {
        EXPECT_GE(info.projectile_dt, info.plates_dt);
        EXPECT_EQ(simulation.dt(), info.plates_dt);
      }
      EXPECT_GT(n_modes(simulation), 0);
      EXPECT_TRUE(n == 0 || n_modes(simulation) == n);
      const auto before   = simulation.momenta();
      const double arm    = simulation.projectile().motion().position.norm();
      double most_elastic = 0.;
      for (int i = 0; simulation.time() < 60e-6; ++i)
      {
        simulation.compute_forces(i % 10 == 0);
        if (i % 10 == 0)
        {
          const auto e = simulation.energies();
          EXPECT_LT(std::abs(e.residual()), 0.005 * e.initial) << "step " << i;
          most_elastic   = std::max(most_elastic, e.elastic);
          const auto now = simulation.momenta();
          EXPECT_LT((now.linear - before.linear).norm(), 1e-12 * before.linear.norm());
          EXPECT_LT((now.angular - before.angular).norm(), 1e-12 * arm * before.linear.norm());
        }
        simulation.advance();
      }
      EXPECT_GT(simulation.broken_bonds(), 10000.);
      EXPECT_GT(most_elastic, 1e-5 * simulation.energies().initial);
      EXPECT_LT(most_elastic, 0.05 * simulation.energies().initial);
    }
}

TEST(ModalProjectile, OscillatesThroughContactAsEnergyAllows)
{
  // Without damage and friction the whole system is nearly linear, and leapfrog conserves its
  // energy.
  Scene scene                          = slender(symmetric(small_scene()));
  scene.projectile.modes               = 8;
  scene.materials[0].critical_stretch  = 10.;
  scene.contact.friction               = ExponentialFriction::Parameters{0., 0., 0.01};
  scene.contact.shank_contact_fraction = 0.;
  scene.impact.speed                   = 30.;
  Simulation simulation(MPI_COMM_SELF, scene);
  double elastic = 0.;
  for (int i = 0; simulation.time() < 60e-6; ++i)
  {
    simulation.compute_forces(true);
    const auto e = simulation.energies();
    EXPECT_LT(std::abs(e.residual()), 2e-4 * e.initial) << "step " << i;
    elastic = std::max(elastic, e.elastic);
    simulation.advance();
  }
  EXPECT_GT(elastic, 1e-4 * simulation.energies().initial);
}

TEST(ModalProjectile, ManyModesFollowTheElements)
{
  Scene scene                         = symmetric(deformable(small_scene()));
  scene.materials[0].critical_stretch = 10.;
  Simulation elements(MPI_COMM_SELF, scene);
  // The same mesh with all the modes that may be asked for, at the same step.
  Scene modes            = modal(scene);
  modes.projectile.modes = 74;
  modes.time.safety_factor *= elements.dt() / Simulation(MPI_COMM_SELF, modes).dt();
  Simulation modal(MPI_COMM_SELF, modes);
  ASSERT_NEAR(modal.dt(), elements.dt(), 1e-12 * modal.dt());
  const Vector3 start = elements.projectile().motion().velocity;
  double stored[2]    = {0., 0.};
  while (elements.time() < 25e-6)
    for (const int i : {0, 1})
    {
      auto &simulation = i == 0 ? elements : modal;
      simulation.compute_forces(true);
      stored[i] = std::max(stored[i], simulation.energies().elastic);
      simulation.advance();
    }
  const Vector3 change = elements.projectile().motion().velocity - start;
  EXPECT_GT(change.norm(), 20.);
  EXPECT_LT((modal.projectile().motion().velocity - elements.projectile().motion().velocity).norm(),
            0.01 * change.norm());
  EXPECT_NEAR(stored[1], stored[0], 0.1 * stored[0]);
}

TEST(ModalProjectile, SaysWhenItIsRigid)
{
  // A sphere of 2 mm rings at a megahertz, the plate's step allows a tenth of that.
  Scene scene                     = modal(symmetric(small_scene()));
  scene.projectile.shape          = {NoseShape::sphere, 2e-3, 2e-3, 1e-3};
  scene.projectile.mass           = 33e-6;
  scene.projectile.youngs_modulus = 400e9;
  const Simulation simulation(MPI_COMM_SELF, scene);
  EXPECT_EQ(n_modes(simulation), 0);
  EXPECT_NE(simulation.projectile().description().find("it is rigid"), std::string::npos);
  EXPECT_EQ(simulation.dt(), simulation.time_step_info().plates_dt);
}

TEST(ModalProjectile, RefusesMoreModesThanTheMeshHas)
{
  Scene scene            = modal(small_scene());
  scene.projectile.modes = 5000;
  EXPECT_THROW(Simulation(MPI_COMM_SELF, scene), InputError);
}
} // namespace
} // namespace ricochet::tests
