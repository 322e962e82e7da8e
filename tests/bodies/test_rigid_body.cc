// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/rigid_body.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
const BodyOfRevolution core({NoseShape::ogive, 6e-3, 28e-3, 10e-3});

RigidBody::Motion at_rest()
{
  return {Vector3::Zero(), Vector3::Zero(), Eigen::Quaterniond::Identity(), Vector3::Zero()};
}

double rotation_energy(const RigidBody &body)
{
  return 0.5 * body.motion().spin.dot(body.angular_momentum());
}

/// The axis of a free symmetric top after the time t: it turns about the angular momentum at the
/// rate L/I_t.
Vector3 precessed_axis(const RigidBody &start, const double t)
{
  const Vector3 L   = start.angular_momentum();
  const double rate = L.norm() / (start.mass() * start.body().gyration_squared()[1]);
  return Eigen::AngleAxisd(rate * t, L.normalized()) * start.axis();
}

RigidBody spinning_top()
{
  auto motion        = at_rest();
  motion.orientation = Eigen::AngleAxisd(0.6, Vector3(1., 2., -1.).normalized());
  motion.spin        = Vector3(3e4, -8e3, 1e4); // rad/s, tumbling after an oblique impact
  return RigidBody(core, 5e-3, motion, false);
}

TEST(RigidBody, TorqueFreeTopPrecessesAsInTheClosedForm)
{
  double error[3];
  const double end = 2e-3; // several turns
  for (const int halving : {0, 1, 2})
  {
    RigidBody body    = spinning_top();
    const auto start  = body;
    const int n_steps = 4000 << halving;
    const double dt   = end / n_steps;
    double energy     = 0.;
    for (int i = 0; i < n_steps; ++i)
    {
      body.advance(Vector3::Zero(), Vector3::Zero(), dt, dt);
      // That of the half steps, which differs from the start's by the square of a step's angle.
      energy = i == 0 ? rotation_energy(body) : energy;
      ASSERT_NEAR(rotation_energy(body), energy, 1e-11 * energy);
      ASSERT_EQ(body.angular_momentum(), start.angular_momentum());
      ASSERT_NEAR(body.motion().orientation.norm(), 1., 1e-15);
    }
    error[halving] = (body.axis() - precessed_axis(start, end)).norm();
  }
  for (const int halving : {0, 1})
    EXPECT_GT(error[halving], 3.7 * error[halving + 1]); // second order
  // 0.016 rad per step: angles off by its square over the ten turns.
  EXPECT_LT(error[0], 2e-3);
}

TEST(RigidBody, SpinAboutAPrincipalAxisIsExact)
{
  auto motion = at_rest();
  motion.spin = Vector3(0., 2e4, 0.);
  RigidBody body(core, 5e-3, motion, false);
  const double dt = 1e-6;
  for (int i = 0; i < 100; ++i)
    body.advance(Vector3::Zero(), Vector3::Zero(), dt, dt);
  const double angle = 100 * dt * 2e4; // nose down for a positive turn about y
  EXPECT_LT((body.axis() - Vector3(std::cos(angle), 0., -std::sin(angle))).norm(),
            1e-13); // rounding of 100 steps
  EXPECT_NEAR(body.axis().z(), -std::sin(angle), 1e-12);
}

TEST(RigidBody, ForceAndMomentAccelerateIt)
{
  RigidBody body(core, 5e-3, at_rest(), false);
  const double dt = 1e-6, inertia = 5e-3 * core.gyration_squared()[1];
  body.advance(Vector3(10., 20., 30.), Vector3(0., 0., 0.1), dt, dt);
  EXPECT_LT((body.motion().velocity - dt / 5e-3 * Vector3(10., 20., 30.)).norm(), 1e-17);
  EXPECT_LT((body.motion().position - dt * dt / 5e-3 * Vector3(10., 20., 30.)).norm(), 1e-22);
  EXPECT_NEAR(body.motion().spin.z(), 0.1 * dt / inertia, 1e-12 * 0.1 * dt / inertia);
  EXPECT_NEAR(
      (body.velocity_at(body.motion().position + Vector3(1e-2, 0., 0.)) - body.motion().velocity)
          .y(),
      1e-2 * body.motion().spin.z(), 1e-15);
}

TEST(RigidBody, PlanarBodyKeepsToThePlane)
{
  auto motion     = at_rest();
  motion.velocity = Vector3(300., 0., -100.);
  RigidBody body(core, 5e-3, motion, /*planar=*/true);
  for (int i = 0; i < 50; ++i)
    body.advance(Vector3(100., 50., -20.), Vector3(0.3, 0.5, -0.2), 1e-6, 1e-6);
  EXPECT_EQ(body.motion().position.y(), 0.);
  EXPECT_EQ(body.motion().velocity.y(), 0.);
  EXPECT_NEAR(body.motion().spin.x(), 0., 1e-9 * body.motion().spin.y());
  EXPECT_NEAR(body.motion().spin.z(), 0., 1e-9 * body.motion().spin.y());
  EXPECT_NEAR(body.axis().y(), 0., 1e-15);
  EXPECT_GT(body.motion().spin.y(), 0.);
}

TEST(RigidBody, DistanceTurnsWithTheBody)
{
  Random random(41);
  auto motion        = at_rest();
  motion.orientation = Eigen::AngleAxisd(1.1, Vector3(0.3, -0.5, 0.8).normalized());
  motion.position    = Vector3(0.1, -0.2, 0.3);
  const RigidBody body(core, 5e-3, motion, false);
  for (int i = 0; i < 50; ++i)
  {
    const Vector3 point = 2e-2 * random.vector();
    const auto here     = body.hit(motion.position + motion.orientation * point),
               there    = core.hit(point);
    EXPECT_NEAR(here.distance, there.distance, 1e-15);
    EXPECT_LT((here.normal - motion.orientation * there.normal).norm(),
              1e-10); // directions of points 1e-16 off
    EXPECT_EQ(here.surface, there.surface);
  }
}

TEST(RigidBody, BoundingBoxIsThatOfASampling)
{
  Random random(43);
  for (const NoseShape nose : {NoseShape::ogive, NoseShape::cone, NoseShape::hemisphere,
                               NoseShape::flat, NoseShape::sphere})
  {
    const BodyOfRevolution shape({nose, 6e-3, 28e-3, 10e-3});
    auto motion = at_rest();
    motion.orientation =
        Eigen::Quaterniond(random.uniform(), random.uniform(), random.uniform(), random.uniform())
            .normalized();
    motion.position = random.vector();
    const RigidBody body(shape, 5e-3, motion, false);
    const auto [low, high] = body.bounding_box();
    Vector3 lowest = Vector3::Constant(1e9), highest = -lowest;
    for (const auto &[x, r] : shape.profile(2000))
      for (int i = 0; i < 720; ++i)
      {
        const Vector3 point =
            motion.position + motion.orientation * Vector3(x, r * std::cos(M_PI * i / 360),
                                                           r * std::sin(M_PI * i / 360));
        lowest  = lowest.cwiseMin(point);
        highest = highest.cwiseMax(point);
      }
    // Half a degree about the axis costs R (0.25 deg)^2/2 = 3e-8 m; the box's own 200 points along
    // the sphere, 47 um apart, (47 um)^2/(8 R) = 9e-8 m.
    EXPECT_LT((low - lowest).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((high - highest).cwiseAbs().maxCoeff(), 1e-7);
  }
}
} // namespace
} // namespace ricochet::tests
