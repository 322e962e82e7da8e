// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <limits>

namespace ricochet::tests
{
namespace
{
TEST(PeridynamicBody, LawThatFixesPoissonsRatioRefusesOtherModuli)
{
  BodySample sample;
  sample.family.law = bond_law_samples[1];
  sample.family.law.shear_modulus *= 1.1;
  EXPECT_THROW(make_body(sample), InputError);
}

TEST(PeridynamicBody, MissingInstructionSetIsRefused)
{
  BodySample sample;
  sample.instruction_set = "abacus";
  EXPECT_THROW(make_body(sample), InputError);
}

TEST(PeridynamicBody, HalfABodyBreaksHalfTheBonds)
{
  // A body pulled apart along x breaks as many bonds as its half, taken twice.
  double n[2];
  for (const bool mirrored : {false, true})
  {
    BodySample sample;
    sample.n                = {8, mirrored ? 4 : 8, 6};
    sample.mirror_y         = mirrored;
    sample.critical_stretch = 0.05;
    if (!mirrored)
      sample.corner.y() = -4. * sample.spacing;
    const auto body = make_body(sample);
    deform(
        *body,
        [](const Vector3 &X) -> Vector3 { return X + Vector3(X.x() > 4e-3 ? 0.5e-3 : 0., 0., 0.); },
        /*breaking=*/true);
    EXPECT_EQ(body->n_broken_bonds(), 0.) << "not booked yet";
    body->book_fracture(1e-7);
    n[mirrored] = body->multiplicity() * body->n_broken_bonds();
  }
  EXPECT_GT(n[0], 100.);
  EXPECT_EQ(n[0], n[1]);
}

TEST(PeridynamicBody, LookBetweenStepsBreaksNothing)
{
  BodySample sample;
  sample.critical_stretch = 0.01;
  const auto body         = make_body(sample);
  const double n          = body->count_bonds();
  deform(
      *body, [](const Vector3 &X) -> Vector3 { return 1.1 * X; }, /*breaking=*/false);
  EXPECT_EQ(body->count_bonds(), n);
  body->break_bonds();
  EXPECT_EQ(body->count_bonds(), 0.);
}

TEST(PeridynamicBody, StepEndsOnce)
{
  const auto body = make_body({});
  deform(*body, [](const Vector3 &X) -> Vector3 { return 1.001 * X; });
  const auto &a      = body->state().arrays;
  const auto p       = body->lattice().index(3, 4, 5);
  const double theta = a.theta[p];
  EXPECT_NEAR(theta, 3e-3, 1e-9);
  EXPECT_EQ(a.theta_before[p], 0.);
  body->end_step();
  EXPECT_EQ(a.theta_before[p], theta);
  body->end_step();
  EXPECT_EQ(a.theta_before[p], theta);
}

TEST(PeridynamicBody, RestUndoesADeformation)
{
  for (const bool mirrored : {false, true})
  {
    BodySample sample;
    sample.n        = {6, 5, 4};
    sample.mirror_y = mirrored;
    const auto body = make_body(sample);
    auto &a         = body->state().arrays;
    Random random(3);
    for_each_point(*body, [&](const std::ptrdiff_t p) { set(a.velocity, p, random.vector()); });
    deform(*body, [&](const Vector3 &X) -> Vector3 { return X + 1e-5 * random.vector(); });
    const double force = largest_force(*body), energy = strain_energy(*body);
    body->rest();
    body->compute_internal_forces({true});
    // Rounding of positions, 1e-18 m, against displacements of 1e-5 m.
    EXPECT_LT(largest_force(*body), 1e-12 * force);
    EXPECT_LT(strain_energy(*body), 1e-24 * energy);
    const auto energies = body->energies(1e-7);
    EXPECT_EQ(energies.kinetic, 0.);
    for_each_point(*body, [&](const std::ptrdiff_t p)
                   { EXPECT_EQ(position(*body, p), reference(*body, p)); });
  }
}

TEST(PeridynamicBody, FirstPointThatIsNotFiniteIsNamed)
{
  BodySample sample;
  sample.n        = {4, 4, 4};
  const auto body = make_body(sample);
  EXPECT_EQ(body->first_not_finite(), "");
  auto &a                                       = body->state().arrays;
  a.force[1][body->lattice().index(3, 0, 0)]    = std::numeric_limits<double>::infinity();
  a.velocity[2][body->lattice().index(1, 2, 3)] = std::nan("");
  EXPECT_EQ(body->first_not_finite(), "The velocity of point (1, 2, 3)");
}

TEST(PeridynamicBody, MomentaAreThoseOfItsPoints)
{
  BodySample sample;
  sample.n        = {5, 4, 3};
  const auto body = make_body(sample);
  const Vector3 drift(1., -2., 3.), spin(0.5, 4., -1.);
  double mass             = 0.;
  Vector3 center          = Vector3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero(); // about the origin
  for_each_point(*body,
                 [&](const std::ptrdiff_t p)
                 {
                   const Vector3 X = reference(*body, p);
                   set(body->state().arrays.velocity, p, drift + 1e3 * spin.cross(X));
                   const double m = body->point_mass();
                   mass += m;
                   center += m * X;
                   inertia +=
                       m * (X.squaredNorm() * Eigen::Matrix3d::Identity() - X * X.transpose());
                 });
  const auto momenta    = body->momenta();
  const Vector3 linear  = mass * drift + 1e3 * spin.cross(center),
                angular = center.cross(drift) + 1e3 * inertia * spin;
  EXPECT_LT((momenta.linear - linear).norm(), 1e-13 * linear.norm());
  EXPECT_LT((momenta.angular - angular).norm(), 1e-13 * angular.norm());
}
} // namespace
} // namespace ricochet::tests
