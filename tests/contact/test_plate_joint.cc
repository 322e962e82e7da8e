// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/plate_joint.h"

#include "ricochet/base/exceptions.h"
#include "support/body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3;
constexpr double dt = 1e-8; // of no consequence here
constexpr PlateJoint::Strength unlimited{unbreakable, unbreakable};

/// A block of points with its upper face at z = 0 and one below it, of another material if asked.
struct Blocks
{
  explicit Blocks(const std::array<int, 3> &n, const bool mirrored = false,
                  const double factor = 1.)
  {
    BodySample sample;
    sample.n        = n;
    sample.mirror_y = mirrored;
    for (const int number : {0, 1})
    {
      sample.number     = number;
      sample.corner.z() = -(number + 1) * n[2] * dx;
      if (number == 1)
        for (double *const modulus :
             {&sample.family.law.bulk_modulus, &sample.family.law.shear_modulus})
          *modulus *= factor;
      bodies.push_back(make_body(sample));
    }
    for (const auto &body : bodies)
      body->update_ghosts();
  }

  /// The joint's own forces on the two bodies, whose points have come to map(reference).
  template <class Map>
  std::array<Vector3, 2> pull(PlateJoint &joint, Map &&map)
  {
    for (const int i : {0, 1})
    {
      for_each_point(*bodies[i],
                     [&](const std::ptrdiff_t p)
                     {
                       set(bodies[i]->state().arrays.position, p, map(i, reference(*bodies[i], p)));
                       set(bodies[i]->state().arrays.force, p, Vector3::Zero());
                     });
      bodies[i]->update_ghosts();
    }
    joint.add_forces(dt);
    std::array<Vector3, 2> sum{Vector3::Zero(), Vector3::Zero()};
    for (const int i : {0, 1})
      for_each_point(*bodies[i], [&](const std::ptrdiff_t p) { sum[i] += force(*bodies[i], p); });
    return sum;
  }

  /// The lower one moved away as a whole.
  Vector3 apart(PlateJoint &joint, const Vector3 &by)
  {
    return pull(joint, [&](const int i, const Vector3 &X) { return Vector3(X + i * by); })[0];
  }

  std::vector<std::unique_ptr<PeridynamicBody>> bodies;
};

PlateJoint joint_of(Blocks &blocks, const PlateJoint::Strength &strength = unlimited)
{
  return {MPI_COMM_SELF, *blocks.bodies[0], *blocks.bodies[1], strength};
}

TEST(PlateJoint, PulledApartTheyCarryStrengthTimesAreaAndThenNothing)
{
  Blocks blocks({8, 6, 4});
  const double M        = p_wave_modulus(blocks.bodies[0]->material());
  const double strength = 1e-3 * M; // at an opening of a thousandth of the spacing
  auto joint            = joint_of(blocks, {strength, unbreakable});
  const double area     = 48. * dx * dx;
  double largest        = 0.;
  for (int i = 1; i <= 999; ++i)
  {
    const Vector3 force = blocks.apart(joint, {0., 0., -1e-6 * dx * i});
    // Springs at 45 degrees turn: as much as the strain, 1e-3, at most.
    EXPECT_NEAR(-force.z(), 1e-3 * i * strength * area, 2e-3 * strength * area);
    EXPECT_EQ(joint.broken_share(), 0.);
    largest = std::max(largest, -force.z());
  }
  EXPECT_NEAR(largest, strength * area, 2e-3 * strength * area);
  const double stored = joint.energy();
  EXPECT_NEAR(stored, 0.5 * strength * strength / M * dx * area, 4e-3 * stored);
  EXPECT_EQ(joint.released_energy(), 0.);

  EXPECT_EQ(blocks.apart(joint, {0., 0., -1.01e-3 * dx}).norm(), 0.);
  EXPECT_EQ(joint.broken_share(), 1.);
  EXPECT_EQ(joint.energy(), 0.);
  // G_c = strength^2 dx/(2 M); the opening was 1.01 times that at the strength.
  EXPECT_NEAR(joint.released_energy(), 1.01 * 1.01 * stored, 0.01 * stored);
  EXPECT_EQ(blocks.apart(joint, {0., 0., 1e-4 * dx}).norm(), 0.) << "broken for ever";
}

TEST(PlateJoint, PressedTogetherTheyDoNotBreak)
{
  Blocks blocks({5, 5, 4});
  const double M      = p_wave_modulus(blocks.bodies[0]->material());
  auto joint          = joint_of(blocks, {1e-3 * M, 1e-3 * M});
  const Vector3 force = blocks.apart(joint, {0., 0., 5e-3 * dx});
  EXPECT_NEAR(force.z(), 5e-3 * M * 25. * dx * dx, 0.01 * force.z());
  EXPECT_EQ(joint.broken_share(), 0.);
}

TEST(PlateJoint, ShearedTheyBreakAtTheShearStrength)
{
  const int n = 12;
  Blocks blocks({n, n, 4});
  const double mu       = blocks.bodies[0]->material().shear_modulus;
  const double strength = 1e-3 * mu;
  for (const int axis : {0, 1})
  {
    auto joint          = joint_of(blocks, {unbreakable, strength});
    Vector3 slip        = Vector3::Zero();
    slip[axis]          = 0.999e-3 * dx;
    const Vector3 force = blocks.apart(joint, slip);
    // Sites have two springs along the slip, at the two edges across it one.
    EXPECT_NEAR(force[axis], 0.999 * strength * (n - 1) * n * dx * dx, 3e-3 * force[axis]);
    slip[axis] = 1.002e-3 * dx;
    blocks.apart(joint, slip);
    // All but those at the two edges.
    EXPECT_NEAR(joint.broken_share(), double(n - 2) / n, 1e-12);
  }
}

TEST(PlateJoint, TensionAndShearAddUpAsSquares)
{
  Blocks blocks({9, 9, 4});
  const auto &material = blocks.bodies[0]->material();
  const double M = p_wave_modulus(material), mu = material.shear_modulus;
  for (const auto &[factor, breaks] : {std::pair<double, bool>{0.99, false}, {1.01, true}})
  {
    auto joint = joint_of(blocks, {1e-4 * M, 2e-4 * mu});
    // 0.6^2 + 0.8^2 = 1
    blocks.apart(joint, factor * Vector3(0.8 * 2e-4 * dx, 0., -0.6e-4 * dx));
    EXPECT_EQ(joint.broken_share() > 0.5, breaks);
  }
}

TEST(PlateJoint, TwoMaterialsAreSpringsInSeries)
{
  Blocks blocks({4, 4, 4}, false, /*factor=*/3.);
  const double M     = p_wave_modulus(blocks.bodies[0]->material());
  auto joint         = joint_of(blocks);
  const double force = -blocks.apart(joint, {0., 0., -1e-6 * dx}).z();
  // dx/2 of M and dx/2 of 3 M.
  EXPECT_NEAR(force, 1e-6 * 1.5 * M * 16. * dx * dx, 1e-5 * force);
}

TEST(PlateJoint, RigidMotionsCostNothing)
{
  Blocks blocks({4, 5, 4});
  auto joint                 = joint_of(blocks);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3(1., 2., 3.).normalized()).matrix();
  const double scale         = p_wave_modulus(blocks.bodies[0]->material()) * dx * dx;
  blocks.pull(joint,
              [&](int, const Vector3 &X) { return Vector3(turn * X + Vector3(1e-3, 0., 2e-3)); });
  for (const auto &body : blocks.bodies)
    EXPECT_LT(largest_force(*body), 1e-12 * scale);
  EXPECT_LT(joint.energy(), 1e-20 * scale * dx);
}

TEST(PlateJoint, ForcesAreMinusTheDerivativeOfTheEnergyAndKeepMomenta)
{
  for (const bool mirrored : {false, true})
  {
    Blocks blocks({4, 4, 4}, mirrored, 2.);
    auto joint        = joint_of(blocks);
    const auto shaken = [&](const int i, const Vector3 &X)
    {
      Vector3 wave = 0.05 * dx *
                     Vector3(std::sin(900. * X.x() + i), std::cos(1300. * X.y() + X.x() * 500.),
                             std::sin(700. * X.x() + 1100. * X.y() + 2. * i));
      return Vector3(X + wave);
    };
    const auto sums    = blocks.pull(joint, shaken);
    const double scale = sums[0].norm();
    EXPECT_GT(scale, 0.);
    Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
    double largest = 0.;
    for (const auto &body : blocks.bodies)
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       linear += force(*body, p);
                       angular += position(*body, p).cross(force(*body, p));
                       largest = std::max(largest, force(*body, p).norm());
                     });
    if (mirrored) // the other half cancels the rest
      linear.y() = angular.x() = angular.z() = 0.;
    EXPECT_LT(linear.norm(), 1e-13 * 32. * largest);
    EXPECT_LT(angular.norm(), 1e-13 * 32. * largest * 8. * dx);

    // A point of either body, near the mirror plane, along all axes.
    for (const int i : {0, 1})
      for (int d = 0; d < 3; ++d)
      {
        const auto &lattice  = blocks.bodies[i]->lattice();
        const auto p         = lattice.index(1, 0, i == 0 ? 0 : 3);
        const double step    = 1e-4 * dx;
        const Vector3 moving = reference(*blocks.bodies[i], p);
        double energy[2];
        for (const int side : {0, 1})
        {
          blocks.pull(joint,
                      [&](const int body, const Vector3 &X)
                      {
                        Vector3 x = shaken(body, X);
                        if (body == i && X == moving)
                          x[d] += (2 * side - 1) * step;
                        return x;
                      });
          energy[side] = joint.energy();
        }
        blocks.pull(joint, shaken);
        // With a mirror plane two points move.
        const double expected = (mirrored ? 2. : 1.) * force(*blocks.bodies[i], p)[d];
        // The difference's own error: (step/dx)^2 of the stiffness.
        EXPECT_NEAR((energy[0] - energy[1]) / (2. * step), expected, 1e-6 * largest);
      }
  }
}

TEST(PlateJoint, HalfOfASymmetricPairIsHalfOfTheWhole)
{
  Blocks whole({6, 8, 4}), half({6, 4, 4}, true);
  // The whole blocks' middle plane is y = 4 dx.
  const auto &material = whole.bodies[0]->material();
  const PlateJoint::Strength strength{0.02 * p_wave_modulus(material),
                                      0.02 * material.shear_modulus};
  auto joint = joint_of(whole, strength), half_joint = joint_of(half, strength);
  const auto bend = [](const double y, const int i, const Vector3 &X)
  { return Vector3(X + i * Vector3(0.01 * dx, 0., -3. * y * y)); };
  whole.pull(joint, [&](const int i, const Vector3 &X) { return bend(X.y() - 4. * dx, i, X); });
  half.pull(half_joint, [&](const int i, const Vector3 &X) { return bend(X.y(), i, X); });
  EXPECT_GT(joint.broken_share(), 0.);
  EXPECT_LT(joint.broken_share(), 1.);
  EXPECT_EQ(half_joint.broken_share(), joint.broken_share());
  EXPECT_NEAR(half_joint.energy(), joint.energy(), 1e-12 * joint.energy());
  EXPECT_NEAR(half_joint.released_energy(), joint.released_energy(),
              1e-12 * joint.released_energy());
}

TEST(PlateJoint, AWavePassesIt)
{
  // A bar along z, once in one piece and once in two. What is thrown back runs up as the rest runs
  // down; of a bar in one piece nothing is.
  const int n_z = 60;
  std::array<double, 2> back{}, through{};
  for (const int pieces : {1, 2})
  {
    BodySample sample;
    std::vector<std::unique_ptr<PeridynamicBody>> bodies;
    for (int i = 0; i < pieces; ++i)
    {
      sample.n          = {6, 6, 2 * n_z / pieces};
      sample.corner.z() = pieces == 1 ? -2 * n_z * dx : -(i + 1) * n_z * dx;
      bodies.push_back(make_body(sample));
    }
    const auto &material = bodies[0]->material();
    const double speed   = std::sqrt(youngs_modulus(material) / material.density);
    std::unique_ptr<PlateJoint> joint;
    if (pieces == 2)
      joint = std::make_unique<PlateJoint>(MPI_COMM_SELF, *bodies[0], *bodies[1], unlimited);
    // Downwards: v = c w', of a bump 20 spacings wide.
    for (const auto &body : bodies)
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       Vector3 X      = reference(*body, p);
                       const double s = (X.z() + 30. * dx) / (10. * dx);
                       const double w = 1e-4 * dx * std::exp(-s * s);
                       set(body->state().arrays.velocity, p,
                           Vector3(0., 0., -2. * s * speed / (10. * dx) * w));
                       X.z() += w;
                       set(body->state().arrays.position, p, X);
                     });
    const double step = 0.2 * dx / std::sqrt(p_wave_modulus(material) / material.density);
    for (int i = 0; i * step * speed < 60. * dx; ++i)
    {
      for (const auto &body : bodies)
        body->update_ghosts();
      for (const auto &body : bodies)
        body->compute_internal_forces({false});
      if (joint)
        joint->add_forces(step);
      for (const auto &body : bodies)
        body->advance(step, step);
    }
    for (const auto &body : bodies)
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       const double z = reference(*body, p).z();
                       const double w = std::abs(position(*body, p).z() - z);
                       if (z > -50. * dx && z < -10. * dx)
                         back[pieces - 1] = std::max(back[pieces - 1], w);
                       if (z < -70. * dx)
                         through[pieces - 1] = std::max(through[pieces - 1], w);
                     });
  }
  // 0.1 % and 2.6 % are seen: faces are softer than the inside, and the bump is twenty spacings
  // wide.
  EXPECT_NEAR(through[1], through[0], 0.005 * through[0]);
  EXPECT_LT(back[1] - back[0], 0.05 * through[0]);
}

TEST(PlateJoint, WhatDoesNotLiePointOnPointIsRefused)
{
  BodySample sample;
  sample.corner.z()  = 0.;
  const auto above   = make_body(sample);
  const auto refused = [&](BodySample below)
  {
    const auto body = make_body(below);
    EXPECT_THROW(PlateJoint(MPI_COMM_SELF, *above, *body, unlimited), InputError);
  };
  sample.corner.z() = -8e-3;
  const auto fits   = make_body(sample);
  EXPECT_NO_THROW(PlateJoint(MPI_COMM_SELF, *above, *fits, unlimited));
  auto other       = sample;
  other.corner.z() = -8.5e-3; // a gap
  refused(other);
  other            = sample;
  other.corner.x() = 0.5e-3;
  refused(other);
  other      = sample;
  other.n[1] = 6;
  refused(other);
  other         = sample;
  other.spacing = 0.5e-3;
  other.n       = {16, 16, 16};
  refused(other);
}
} // namespace
} // namespace ricochet::tests
