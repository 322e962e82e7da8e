// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one pair in contact, without any loop around it.
#include "ricochet/base/vector.h"
#include "ricochet/contact/pair_law.h"
#include "support/laws.h"

#include <Sacado_Fad_SFad.hpp>
#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Derivative = Sacado::Fad::SFad<double, 1>; // a number and its derivatives

constexpr double stiffness = 5e6, shank_force = 40., v_reg = 5.;
const PairLaw<double> law{stiffness, shank_force, v_reg};

// From rest through the regularisation speed to that of the impact [m/s].
constexpr double speeds[] = {0., 1e-12, 1e-3, 1., 4.999, 5., 5.001, 20., 300., 2000.};

TEST(PairLaw, NormalForceIsMinusTheDerivativeOfTheEnergyByTheGap)
{
  const PairLaw<Derivative> differentiable{stiffness, shank_force, v_reg};
  for (const double depth : {0., 1e-9, 1e-5, 2e-4, 1e-3})
  {
    const Derivative gap(1, 0, -depth); // the one variable; touching: negative
    const Derivative energy = differentiable.energy(-gap);
    const double force      = law.normal_force(depth);
    EXPECT_DOUBLE_EQ(energy.val(), law.energy(depth));
    EXPECT_DOUBLE_EQ(force, -energy.dx(0)) << depth;
    EXPECT_GE(force, 0.) << "contact pushes, it never pulls";
    // A spring: the second derivative is k everywhere.
    EXPECT_DOUBLE_EQ(differentiable.normal_force(-gap).dx(0), -stiffness);
  }
}

/// Friction at full normal force, without a bound.
Vector3 coulomb(const Vector3 &sliding, const double full)
{
  return -law.resistance(sliding.norm(), full, 0., 0.) * sliding;
}

TEST(PairLaw, FrictionIsTheOneOfCoulombAndContinuousInTheSlidingSpeed)
{
  const double normal = 1000., mu = 0.3;
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  for (const double speed : speeds)
  {
    const Vector3 f = coulomb(speed * along, mu * normal);
    EXPECT_LT((f + mu * normal * std::min(1., speed / v_reg) * along).norm(), 1e-12 * mu * normal)
        << speed;
  }
}

TEST(PairLaw, ShankIsPushedOnlyWhereTheTargetFlows)
{
  EXPECT_EQ(law.shank_push(0.), 0.);
  EXPECT_EQ(law.shank_push(shank_force), 0.) << "below its flow pressure a target is elastic";
  EXPECT_DOUBLE_EQ(law.shank_push(1.25 * shank_force), 0.25 * shank_force);
  EXPECT_EQ(law.shank_push(2. * shank_force), shank_force);
  EXPECT_EQ(law.shank_push(1e6 * shank_force), shank_force);
  EXPECT_EQ((PairLaw<double>{stiffness, 0., v_reg}).shank_push(1000.), 0.);
}

TEST(PairLaw, SlopeOfFrictionIsThatOfTheRegularisation)
{
  // d|f|/dv: mu f_n/v_reg below the regularisation speed, none above it.
  const double normal = 1000., mu = 0.3;
  const PairLaw<Derivative> differentiable{stiffness, shank_force, v_reg};
  for (const double v : {0.1, 4.9, 5.1, 300.})
  {
    const Derivative speed(1, 0, v);
    const Derivative f =
        differentiable.resistance(speed, mu * normal, Derivative(0.), Derivative(0.)) * speed;
    EXPECT_NEAR(f.dx(0), v < v_reg ? mu * normal / v_reg : 0., 1e-12 * mu * normal) << v;
  }
}

TEST(PairLaw, ForcesOnThePairAreOppositeWhicheverComesFirst)
{
  // Momentum, exactly: who of the two is asked for changes the sign of all forces and nothing else.
  const double depth = 2e-4, mu = 0.3;
  const Vector3 n  = Vector3(1., 2., -1.).normalized(), velocity(120., -35., 7.);
  const auto force = [&](const Vector3 &normal, const Vector3 &relative, const double dt)
  {
    const Vector3 sliding = sliding_velocity(relative, normal);
    const double f_n      = law.normal_force(depth);
    return Vector3(f_n * normal -
                   law.resistance(sliding.norm(), mu * f_n, /*compliance=*/1e6, dt) * sliding);
  };
  for (const double dt : {0., 1e-8})
  {
    const Vector3 on_second = force(n, velocity, dt);
    EXPECT_GT(on_second.norm(), law.normal_force(depth)) << "friction must be in it";
    EXPECT_EQ(on_second, Vector3(-force(-n, -velocity, dt)));
  }
  EXPECT_NEAR(sliding_velocity(velocity, n).dot(n), 0., 1e-13 * velocity.norm());
}

TEST(PairLaw, FrictionNeverGivesEnergy)
{
  // Power of friction on the sliding, of every friction law, from rest on.
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  for (const auto &parameters : friction_law_samples)
  {
    const auto friction_law = make_friction_law(parameters);
    for (const double depth : {1e-5, 1e-3})
      for (const double speed : speeds)
      {
        const Vector3 sliding = speed * along;
        const double full     = friction_law->coefficient(speed) * law.normal_force(depth);
        const double heat     = -coulomb(sliding, full).dot(sliding);
        EXPECT_GE(heat, 0.) << FrictionLaws::names()[parameters.index()] << " at " << speed;
        EXPECT_EQ(heat > 0., speed > 0.)
            << FrictionLaws::names()[parameters.index()] << " at " << speed;
      }
  }
}

TEST(PairLaw, BoundedFrictionNeverReversesSliding)
{
  // However hard two points of any masses are pressed: sliding decreases and keeps its direction;
  // without the bound it would not.
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  const double dt     = 1e-7;
  bool needed         = false;
  for (const double mass : {1e-9, 1e-6, 1e-3})
    for (const double f_n : {0., 1., 1e4, 1e9})
      for (const double speed : speeds)
      {
        const Vector3 sliding = speed * along, unbounded = coulomb(sliding, 0.3 * f_n);
        const Vector3 f    = -law.resistance(speed, 0.3 * f_n, 1. / mass, dt) * sliding;
        const double after = (sliding + dt / mass * f).dot(along);
        EXPECT_GE(after, -1e-15 * speed) << speed << " m/s, " << f_n << " N, " << mass << " kg";
        EXPECT_LE(after, (1. + 1e-15) * speed); // the length of a unit vector is rounded
        needed = needed || (sliding + dt / mass * unbounded).dot(along) < 0.;
        // Where the bound does not bind, it is Coulomb's law.
        if (unbounded.norm() < mass * speed / dt)
        {
          EXPECT_LE((f - unbounded).norm(), 1e-14 * unbounded.norm());
        }
      }
  EXPECT_TRUE(needed);
}

TEST(PairLaw, WorkOfAStepIsTheKineticEnergyThatTheForceAdds)
{
  const double mass = 2e-6, dt = 3e-8;
  const Vector3 before(100., -20., 3.), force(-1000., 300., 50.),
      after          = before + dt / mass * force;
  const double added = 0.5 * mass * (after.squaredNorm() - before.squaredNorm());
  EXPECT_NEAR(work_of_step(force, before, after, dt), added, 1e-13 * std::abs(added));
}
} // namespace
} // namespace ricochet::tests
