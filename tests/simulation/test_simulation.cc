// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
/// Calls visit() every `interval` steps between evaluate() and advance().
template <class Visitor>
void run(Simulation &simulation, const int n_steps, const int interval, Visitor &&visit)
{
  for (int i = 0; i <= n_steps; ++i)
  {
    const bool due = i % interval == 0;
    simulation.compute_forces(/*energy=*/due);
    if (due)
      visit();
    simulation.advance();
  }
}

/// Whose broken bonds carry nothing: debris takes over at once.
Scene crumbling(Scene scene)
{
  scene.materials[0].cracks_push = false;
  return scene;
}

Scene flowing(Scene scene)
{
  scene.materials[0].flow = {66.78e6, 0.06933, 0.223};
  return scene;
}

class Impact : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(
    Scenes, Impact,
    testing::Values(small_scene(), symmetric(small_scene()), two_plates(), symmetric(two_plates()),
                    relaxing(small_scene(), HistoryPrecision::single_precision),
                    crumbling(small_scene()), flowing(small_scene()), joined(two_plates())),
    [](const auto &info)
    {
      return std::string(info.param.symmetric ? "Half" : "Full") +
             (info.param.plates.size() > 1 ? "TwoPlates" : "OnePlate") +
             (info.param.materials[0].relaxation.empty() ? "" : "Relaxing") +
             (info.param.materials[0].cracks_push ? "" : "Crumbling") +
             (info.param.materials[0].flow.flows() ? "Flowing" : "") +
             (info.param.plates.back().has_joint() ? "Joined" : "");
    });

TEST_P(Impact, EnergyBalanceClosesWithDamageAndDebris)
{
  Simulation simulation(MPI_COMM_SELF, GetParam());
  double most_debris = 0., most_friction = 0., most_viscous = 0., most_plastic = 0.;
  run(simulation, 200, 10,
      [&]
      {
        const auto e = simulation.energies();
        // Every term but the residual has its own formula. What is left is the time step's error at
        // the kinks of contact: 1 % of the initial energy is the bound we promise; about 0.25 % is
        // seen.
        EXPECT_LT(std::abs(e.residual()), 0.01 * e.initial) << "step " << simulation.step();
        most_debris   = std::max(most_debris, e.debris);
        most_friction = std::max(most_friction, e.friction);
        most_viscous  = std::max(most_viscous, e.viscous);
        most_plastic  = std::max(most_plastic, e.plastic);
      });
  // Otherwise the test would say nothing about these terms.
  EXPECT_GT(simulation.broken_bonds(), 10000.);
  // Closed cracks leave debris less to carry.
  const auto &material = GetParam().materials[0];
  EXPECT_GT(most_debris, (material.cracks_push ? 0.001 : 0.005) * simulation.energies().initial);
  EXPECT_GT(most_friction, 0.05 * simulation.energies().initial);
  if (!GetParam().materials[0].relaxation.empty())
  {
    EXPECT_GT(most_viscous, 0.02 * simulation.energies().initial);
  }
  if (material.flow.flows())
  {
    EXPECT_GT(most_plastic, 0.02 * simulation.energies().initial);
  }
}

TEST_P(Impact, MomentumAndAngularMomentumDoNotDrift)
{
  Simulation simulation(MPI_COMM_SELF, GetParam());
  const auto before = simulation.momenta();
  EXPECT_NEAR(before.linear.norm(), 0.8e-3 * 300., 1e-15); // mass times speed of the scene
  const double arm = simulation.projectile().motion().position.norm();
  run(simulation, 300, 20,
      [&]
      {
        const auto now = simulation.momenta();
        // Pair forces are equal and opposite to rounding; 300 steps add up like a random walk.
        EXPECT_LT((now.linear - before.linear).norm(), 1e-12 * before.linear.norm());
        EXPECT_LT((now.angular - before.angular).norm(), 1e-12 * arm * before.linear.norm());
      });
  // The plate has taken over a good part of it.
  EXPECT_GT((simulation.projectile().motion().velocity * 0.8e-3 - before.linear).norm(),
            0.3 * before.linear.norm());
}

TEST(Simulation, FrictionOfDebrisStandsInTheBalanceAndKeepsMomentum)
{
  for (const bool half : {false, true})
  {
    Scene scene                   = half ? symmetric(two_plates()) : two_plates();
    scene.contact.debris_friction = 1.;
    Simulation simulation(MPI_COMM_SELF, scene);
    const auto before = simulation.momenta();
    run(simulation, 200, 10,
        [&]
        {
          const auto e = simulation.energies();
          EXPECT_LT(std::abs(e.residual()), 0.01 * e.initial) << "step " << simulation.step();
          const Vector3 drift = simulation.momenta().linear - before.linear;
          EXPECT_LT(drift.norm(), 1e-12 * before.linear.norm());
        });
    // More than the bound of the residual, or the test would say nothing.
    EXPECT_GT(simulation.energies().debris_friction, 0.015 * simulation.energies().initial);
  }
}

TEST(Simulation, TrajectoryConvergesInTheTimeStepAtSecondOrder)
{
  // Unbroken and without friction: sliding friction sees the velocity of half a step ago, which is
  // first order.
  Scene scene                         = symmetric(small_scene());
  scene.materials[0].critical_stretch = 10.;
  scene.contact.friction              = ConstantFriction::Parameters{0.};
  Vector3 position[4];
  for (const int halving : {0, 1, 2, 3})
  {
    Scene finer = scene;
    finer.time.safety_factor /= 1 << halving;
    Simulation simulation(MPI_COMM_SELF, finer);
    run(simulation, 40 * (1 << halving) - 1, 1000, [] {});
    position[halving] = simulation.projectile().motion().position;
  }
  // Points that touch and let go between two steps disturb the factor 4 a little.
  for (const int halving : {0, 1})
    EXPECT_GT((position[halving] - position[halving + 1]).norm(),
              3. * (position[halving + 1] - position[halving + 2]).norm());
  EXPECT_LT((position[0] - position[1]).norm(), 1e-3 * 1e-3); // a thousandth of the spacing
}

class HalfModel : public testing::TestWithParam<Scene>
{
protected:
  /// Both models with the same time step: the bound finds the limit of each to about 1 %,
  /// and trajectories with different steps would differ by their discretisation error.
  void compare(const double critical_stretch, const int n_steps, const double tolerance)
  {
    Scene scene                         = GetParam();
    scene.materials[0].critical_stretch = critical_stretch;
    Scene half_scene                    = symmetric(scene);
    Simulation full(MPI_COMM_SELF, scene);
    half_scene.time.safety_factor *= full.dt() / Simulation(MPI_COMM_SELF, half_scene).dt();
    Simulation half(MPI_COMM_SELF, half_scene);
    ASSERT_NEAR(half.dt(), full.dt(), 1e-15 * full.dt());

    for (int i = 0; i < n_steps; ++i)
    {
      full.compute_forces(true);
      half.compute_forces(true);
      if (i % 20 == 0)
      {
        const auto &f = full.projectile().motion(), &h = half.projectile().motion();
        EXPECT_LT((f.velocity - h.velocity).norm(), tolerance * 300.) << "step " << i;
        EXPECT_LT((f.position - h.position).norm(), tolerance * 1e-3) << "step " << i;
        EXPECT_LT((f.spin - h.spin).norm(), tolerance * 1e4) << "step " << i;
        const auto e = full.energies(), g = half.energies();
        for (const auto term : std::initializer_list<double EnergyBalance::*>{
                 &EnergyBalance::projectile, &EnergyBalance::kinetic, &EnergyBalance::strain,
                 &EnergyBalance::contact, &EnergyBalance::debris, &EnergyBalance::friction,
                 &EnergyBalance::fracture, &EnergyBalance::initial, &EnergyBalance::viscous})
          EXPECT_NEAR(e.*term, g.*term, tolerance * e.initial) << "step " << i;
        EXPECT_EQ(full.broken_bonds(), half.broken_bonds());
        EXPECT_EQ(full.n_bonds(), half.n_bonds());
        EXPECT_EQ(full.reaction().n_touching, half.reaction().n_touching);
      }
      full.advance();
      half.advance();
    }
    broken_bonds_ = full.broken_bonds();
  }

  double broken_bonds_ = 0.;
};

// Single precision would round the history of both halves' bonds to 6e-8 in different directions.
INSTANTIATE_TEST_SUITE_P(Scenes, HalfModel,
                         testing::Values(small_scene(), two_plates(),
                                         relaxing(small_scene(),
                                                  HistoryPrecision::double_precision)),
                         [](const auto &info)
                         {
                           return std::string(info.param.plates.size() > 1 ? "TwoPlates"
                                                                           : "OnePlate") +
                                  (info.param.materials[0].relaxation.empty() ? "" : "Relaxing");
                         });

TEST_P(HalfModel, EqualsTheFullModelBeforeDamage)
{
  compare(/*critical_stretch=*/10., 120, 1e-12); // rounding: sums are made in another order
  EXPECT_EQ(broken_bonds_, 0.);
}

TEST_P(HalfModel, EqualsTheFullModelWithDamageAndDebris)
{
  // Colliding debris amplifies rounding about tenfold in 30 steps; 160 steps of 1e-16 stay below
  // 1e-10.
  compare(/*critical_stretch=*/0.01, 160, 1e-10);
  EXPECT_GT(broken_bonds_, 30000.);
}

TEST(Simulation, ProjectileInsideAPlateIsRefused)
{
  Scene scene            = small_scene();
  scene.impact.clearance = -1e-3;
  try
  {
    Simulation simulation(MPI_COMM_SELF, scene);
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("starts inside plate 1"), std::string::npos) << message;
    EXPECT_NE(message.find("Clearance"), std::string::npos) << message;
  }
}

TEST(Simulation, UnknownMaterialIsRefused)
{
  Scene scene              = small_scene();
  scene.plates[0].material = "unobtainium";
  EXPECT_THROW(Simulation(MPI_COMM_SELF, scene), InputError);
}

TEST(Simulation, PlatesStackDownwardsFromTheUpperFace)
{
  Scene scene         = two_plates();
  scene.plates[1].gap = 2e-3;
  const Simulation simulation(MPI_COMM_SELF, scene);
  const auto [low, high] = simulation.target_box();
  // 30 x 16 mm, 4 + 2 + 4 mm in depth, the first upper face at z = 0 (scene/scene.h).
  EXPECT_LT((low - Vector3(0., -8e-3, -10e-3)).norm(), 1e-15);
  EXPECT_LT((high - Vector3(30e-3, 8e-3, 0.)).norm(), 1e-15);
  EXPECT_EQ(simulation.n_points(), 2 * 30 * 16 * 4);
}

TEST(Simulation, ProjectileStartsAtTheClearanceAboveTheEntryPoint)
{
  for (const double angle : {10., 30., 60., 90.})
  {
    Scene scene                  = small_scene();
    scene.impact.incidence_angle = angle * units::deg;
    const Simulation simulation(MPI_COMM_SELF, scene);
    // The profile has 200 points along the nose.
    EXPECT_NEAR(simulation.projectile().bounding_box().first.z(), 0.1e-3, 1e-6);
    EXPECT_NEAR(simulation.projectile().pitch(), -angle * units::deg, 1e-12);
    EXPECT_NEAR(simulation.projectile().motion().velocity.z(), -300. * std::sin(angle * units::deg),
                1e-12 * 300.);
  }
}

TEST(Simulation, FreeProjectileFliesStraight)
{
  Scene scene            = small_scene();
  scene.impact.clearance = 5e-3; // touches nothing for 33 us
  Simulation simulation(MPI_COMM_SELF, scene);
  const Vector3 start = simulation.projectile().motion().position,
                v     = simulation.projectile().motion().velocity;
  run(simulation, 29, 1000, [] {});
  EXPECT_LT((simulation.projectile().motion().position - start - simulation.time() * v).norm(),
            1e-16 * 30.);
  EXPECT_EQ(simulation.step(), 30);
  EXPECT_NEAR(simulation.time(), 30 * simulation.dt(), 1e-14 * simulation.time());
  EXPECT_EQ(simulation.broken_bonds(), 0.);
}

TEST(Simulation, FieldThatIsNotANumberIsReportedWithItsPlace)
{
  Simulation simulation(MPI_COMM_SELF, small_scene());
  simulation.compute_forces(false);
  EXPECT_NO_THROW(simulation.check_finite());
  const auto &l = simulation.plates()[0]->lattice();
  simulation.plates()[0]->state().arrays.velocity[1][l.index(3, 4, 5)] = std::nan("");
  try
  {
    simulation.check_finite();
    FAIL() << "no error";
  }
  catch (const RunError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("velocity of point (3, 4, 5) of plate 1"), std::string::npos) << message;
  }
}
} // namespace
} // namespace ricochet::tests
