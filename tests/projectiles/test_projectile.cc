// SPDX-License-Identifier: LGPL-2.1-or-later
// Where projectiles start, whatever they are made of.
#include "ricochet/projectiles/projectile.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
class StartOfProjectile : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(Models, StartOfProjectile,
                         testing::Values(small_scene(), modal(small_scene()),
                                         deformable(small_scene()), peridynamic(small_scene()),
                                         peridynamic_nose(small_scene())),
                         [](const auto &model) { return model_name(model.param); });

TEST_P(StartOfProjectile, LowestPointIsAboveTheEntryPointAndTheAxisInclined)
{
  const auto law = make_friction_law(GetParam().contact.friction);
  for (const double attack : {0., 5., -5.})
    for (const bool half : {false, true})
    {
      Scene scene               = GetParam();
      scene.symmetric           = half;
      scene.impact.attack_angle = attack * units::deg;
      const auto projectile     = make_projectile(MPI_COMM_SELF, scene, *law, {});
      const double incidence    = scene.impact.incidence_angle;
      EXPECT_NEAR(projectile->pitch(), scene.impact.attack_angle - incidence, 1e-9);
      const Vector3 along(std::cos(incidence), 0., -std::sin(incidence));
      EXPECT_LT((projectile->motion().velocity - scene.impact.speed * along).norm(), 1e-9 * 300.);
      EXPECT_LT(projectile->motion().spin.norm(), 1e-6);
      EXPECT_NEAR(projectile->mass(), scene.projectile.mass, 1e-15);
      // Facets may stand out of the shape or lie within it, by a fraction of the diameter.
      const bool rigid       = scene.projectile.model == ProjectileModel::rigid;
      const auto [low, high] = projectile->bounding_box();
      EXPECT_GE(low.z(), rigid ? scene.impact.clearance - 1e-6 : -1e-15);
      EXPECT_LT(low.z(), scene.impact.clearance + (rigid ? 1e-6 : 0.1 * 5e-3));
      EXPECT_NEAR(low.y() + high.y(), 0., 1e-15); // also of a half, which is completed
      EXPECT_GT(high.x(), scene.impact.entry_x - scene.impact.clearance / std::tan(incidence));
      EXPECT_LT(low.x(), scene.impact.entry_x);
    }
}

TEST_P(StartOfProjectile, ItFliesToTheEntryPointFromWhereverItStarts)
{
  const auto law               = make_friction_law(GetParam().contact.friction);
  Scene scene                  = GetParam();
  scene.impact.incidence_angle = 10. * units::deg;
  scene.impact.clearance       = 1e-3;
  const auto near              = make_projectile(MPI_COMM_SELF, scene, *law, {});
  scene.impact.clearance       = 5e-3;
  const auto far               = make_projectile(MPI_COMM_SELF, scene, *law, {});
  const Vector3 between        = near->motion().position - far->motion().position;
  EXPECT_NEAR(between.z(), -4e-3, 1e-12);
  EXPECT_LT(between.cross(near->motion().velocity).norm(), 1e-12 * 300.);
}

TEST_P(StartOfProjectile, ItYawsAndSpinsAboutItsAxis)
{
  const auto law         = make_friction_law(GetParam().contact.friction);
  Scene scene            = GetParam();
  scene.impact.yaw_angle = 5. * units::deg;
  scene.impact.spin      = 1000.;
  const auto projectile  = make_projectile(MPI_COMM_SELF, scene, *law, {});
  const auto &motion     = projectile->motion();
  const Vector3 axis     = motion.orientation * Vector3::UnitX();
  EXPECT_NEAR(axis.y(), std::sin(scene.impact.yaw_angle), 1e-7); // of points: a root of rounding
  EXPECT_NEAR(std::atan2(axis.z(), axis.x()), -scene.impact.incidence_angle, 1e-7);
  EXPECT_LT((motion.spin - 1000. * axis).norm(), 1e-3);
  EXPECT_GE(projectile->bounding_box().first.z(), -1e-15);
}

TEST_P(StartOfProjectile, EnergyAndMomentumAreThoseOfThePoint)
{
  const auto law = make_friction_law(GetParam().contact.friction);
  for (const bool half : {false, true})
  {
    Scene scene           = GetParam();
    scene.symmetric       = half;
    const auto projectile = make_projectile(MPI_COMM_SELF, scene, *law, {});
    projectile->update_ghosts();
    projectile->compute_internal_forces({/*energy=*/true});
    projectile->complete_forces();
    const auto energy  = projectile->multiplicity() * projectile->energies(1e-9);
    const double exact = 0.5 * 0.8e-3 * 300. * 300.;
    EXPECT_NEAR(energy.kinetic, exact, 1e-9 * exact);
    EXPECT_NEAR(energy.strain, 0., 1e-9 * exact);
    const Vector3 p = (projectile->multiplicity() * projectile->momenta()).linear;
    EXPECT_NEAR(p.x(), 0.8e-3 * 300. * std::cos(M_PI / 6.), 1e-12);
    EXPECT_NEAR(p.z(), -0.8e-3 * 300. * std::sin(M_PI / 6.), 1e-12);
    EXPECT_EQ(projectile->first_not_finite(), "");
  }
}
} // namespace
} // namespace ricochet::tests
