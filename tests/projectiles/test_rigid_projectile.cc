// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projectiles/rigid_projectile.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ricochet::tests
{
namespace
{
struct Flyer
{
  Scene scene                      = small_scene();
  std::unique_ptr<FrictionLaw> law = make_friction_law(scene.contact.friction);

  RigidProjectile at(const RigidBody::Motion &start) const
  {
    return {MPI_COMM_SELF, scene, start, *law, {}};
  }
};

RigidBody::Motion tumbling()
{
  return {Vector3(0.02, -0.01, 0.03), Vector3(200., 10., -100.),
          Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vector3(1., 2., 3.).normalized())),
          Vector3(3000., 2000., -1000.)};
}

TEST(RigidProjectile, FreeFlightKeepsMomentaAndEnergy)
{
  const Flyer flyer;
  auto body           = flyer.at(tumbling());
  constexpr double dt = 1e-7;
  body.compute_internal_forces({});
  const auto before         = body.momenta();
  const double first_energy = body.energies(dt).kinetic;
  EXPECT_LT((before.linear - 0.8e-3 * tumbling().velocity).norm(), 1e-12);
  for (int step = 0; step < 1000; ++step)
  {
    body.compute_internal_forces({});
    body.advance(dt, dt);
  }
  const auto after = body.momenta();
  EXPECT_LT((after.linear - before.linear).norm(), 1e-13 * before.linear.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 1e-10 * before.angular.norm());
  EXPECT_NEAR(body.energies(dt).kinetic, first_energy, 1e-6 * first_energy);
  EXPECT_EQ(body.friction_work(), 0.);
  EXPECT_EQ(body.squared_frequency(), 0.);
  EXPECT_EQ(body.vibration(), nullptr);
}

TEST(RigidProjectile, SurfaceLiesOnTheShape)
{
  const Flyer flyer;
  const auto body  = flyer.at(tumbling());
  const auto frame = body.surface();
  const RigidBody rigid(body.body(), body.mass(), tumbling(), false);
  ASSERT_GT(frame.vertices.size(), 100u);
  const auto [low, high] = body.bounding_box();
  for (const auto &x : frame.vertices)
  {
    EXPECT_NEAR(rigid.hit(x).distance, 0., 1e-6);
    EXPECT_TRUE(((x - low).array() > -1e-6).all() && ((high - x).array() > -1e-6).all());
  }
  for (const auto &quad : frame.quads)
    for (const auto corner : quad)
      EXPECT_LT(static_cast<std::size_t>(corner), frame.vertices.size());
}

TEST(RigidProjectile, SaysWhenItsPositionIsLost)
{
  const Flyer flyer;
  EXPECT_EQ(flyer.at(tumbling()).first_not_finite(), "");
  auto lost         = tumbling();
  lost.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(flyer.at(lost).first_not_finite(), "");
}

TEST(RigidProjectile, OfPrescribedVelocityKeepsItAndTheBalancesKnow)
{
  Scene scene             = small_scene();
  scene.projectile.driven = true;
  Simulation simulation(MPI_COMM_SELF, scene);
  const auto start = simulation.momenta();
  const Vector3 v  = simulation.projectile().motion().velocity;
  for (int step = 0; step < 120; ++step)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  simulation.compute_forces(true);
  const auto energies = simulation.energies();
  EXPECT_EQ(simulation.projectile().motion().velocity, v);
  EXPECT_EQ(simulation.present_motion().spin.norm(), 0.);
  EXPECT_EQ(energies.projectile, energies.initial);
  EXPECT_GT(energies.drive, 0.05 * energies.initial);
  EXPECT_LT(std::abs(energies.residual()), 0.01 * energies.drive);
  EXPECT_GT(energies.friction, 0.);
  const auto now = simulation.momenta();
  EXPECT_LT((now.linear - start.linear).norm(), 1e-12 * start.linear.norm());
  EXPECT_LT((now.angular - start.angular).norm(),
            1e-3 * start.angular.norm()); // debris: doc/theory.md
}
} // namespace
} // namespace ricochet::tests
