// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one pair in contact, without any loop around it.
#include "ricochet/base/vector.h"
#include "ricochet/contact/pair_law.h"
#include "support/laws.h"

#include <Sacado_Fad_DFad.hpp>
#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Derivative = Sacado::Fad::DFad<double>; // a number and its derivatives

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

TEST(PairLaw, FrictionIsTheOneOfCoulombAndContinuousInTheSlidingSpeed)
{
  const double normal = 1000., mu = 0.3;
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  for (const double speed : speeds)
  {
    const Vector3 f = law.friction_limit(mu, normal) * law.direction(Vector3(speed * along), speed);
    EXPECT_LT((f + mu * normal * std::min(1., speed / v_reg) * along).norm(), 1e-12 * mu * normal)
        << speed;
  }
  EXPECT_EQ(law.shank_limit(mu), mu * shank_force);
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
        differentiable.friction_limit(mu, normal) * speed / differentiable.regularised(speed);
    EXPECT_NEAR(f.dx(0), v < v_reg ? mu * normal / v_reg : 0., 1e-12 * mu * normal) << v;
  }
}

TEST(PairLaw, ForcesOnThePairAreOppositeWhicheverComesFirst)
{
  // Momentum, exactly: who of the two is asked for changes the sign of all forces and nothing else.
  const double depth = 2e-4, mu = 0.3, mass = 1e-6, dt = 1e-8;
  const Vector3 n  = Vector3(1., 2., -1.).normalized(), velocity(120., -35., 7.);
  const auto force = [&](const Vector3 &normal, const Vector3 &relative, const bool bounded)
  {
    const Vector3 sliding = sliding_velocity(relative, normal);
    const double f_n      = law.normal_force(depth);
    return bounded ? Vector3(f_n * normal + law.bounded_friction(sliding, mu, f_n, mass, dt))
                   : Vector3(f_n * normal + (law.friction_limit(mu, f_n) + law.shank_limit(mu)) *
                                                law.direction(sliding, sliding.norm()));
  };
  for (const bool bounded : {false, true})
  {
    const Vector3 on_second = force(n, velocity, bounded);
    EXPECT_GT(on_second.norm(), law.normal_force(depth)) << "friction must be in it";
    EXPECT_EQ(on_second, Vector3(-force(-n, -velocity, bounded)));
  }
  EXPECT_NEAR(sliding_velocity(velocity, n).dot(n), 0., 1e-13 * velocity.norm());
}

TEST(PairLaw, FrictionNeverGivesEnergy)
{
  // Power of friction and shank on the sliding, of every friction law, from rest on.
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  for (const auto &parameters : friction_law_samples)
  {
    const auto friction_law = make_friction_law(parameters);
    for (const double depth : {0., 1e-5, 1e-3})
      for (const double speed : speeds)
      {
        const Vector3 sliding = speed * along;
        const double mu = friction_law->coefficient(speed), f_n = law.normal_force(depth);
        const double heat = -(law.friction_limit(mu, f_n) + law.shank_limit(mu)) *
                            law.direction(sliding, speed).dot(sliding);
        EXPECT_GE(heat, 0.) << FrictionLaws::names()[parameters.index()] << " at " << speed;
        EXPECT_EQ(heat > 0., speed > 0.)
            << FrictionLaws::names()[parameters.index()] << " at " << speed;
        EXPECT_GE(-law.bounded_friction(sliding, mu, f_n, 1e-6, 1e-8).dot(sliding), 0.);
      }
  }
}

TEST(PairLaw, BoundedFrictionNeverReversesSliding)
{
  // Two points of any masses, up to as many contacts at once as the law counts upon, however hard
  // they are pressed: sliding decreases and keeps its direction; without the bound it would not.
  const Vector3 along = Vector3(3., -4., 12.) / 13.;
  const double dt     = 1e-7;
  bool needed         = false;
  for (const double mass : {1e-9, 1e-6, 1e-3})
    for (const double f_n : {0., 1., 1e4, 1e9})
      for (const double speed : speeds)
      {
        const Vector3 sliding = speed * along;
        const Vector3 f       = law.bounded_friction(sliding, 0.3, f_n, mass, dt);
        for (const double contacts : {1., contacts_of_a_point})
        {
          const double after = (sliding + contacts * dt / mass * f).dot(along);
          EXPECT_GE(after, -1e-15 * speed) << speed << " m/s, " << f_n << " N, " << mass << " kg";
          EXPECT_LE(after, (1. + 1e-15) * speed); // the length of a unit vector is rounded
        }
        const Vector3 unbounded = law.friction_limit(0.3, f_n) * law.direction(sliding, speed);
        needed                  = needed || (sliding + dt / mass * unbounded).dot(along) < 0.;
        // Where the bound does not bind, it is Coulomb's law.
        if (unbounded.norm() < mass * speed / (contacts_of_a_point * dt))
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
