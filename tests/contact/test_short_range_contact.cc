// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/constant_friction.h"
#include "ricochet/contact/exponential_friction.h"
#include "ricochet/contact/short_range_contact.h"
#include "support/body.h"

#include <gtest/gtest.h>

#include <functional>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3;

using Bodies = std::vector<std::unique_ptr<PeridynamicBody>>;

/// A body of one point at `position`, which the lattice puts half a spacing from its corner.
std::unique_ptr<PeridynamicBody> one_point(const int number, const Vector3 &position)
{
  BodySample sample;
  sample.n      = {1, 1, 1};
  sample.corner = position - Vector3::Constant(0.5 * dx);
  sample.number = number;
  return make_body(sample);
}

/// f = factor 18 K V^2 / (pi delta^5): Macek and Silling 2007, with c = 18 K / (pi delta^4) at the
/// stretch (d - r)/delta.
double pair_stiffness(const PeridynamicBody &body, const double factor)
{
  return factor * 18. * body.material().bulk_modulus * std::pow(dx, 6) /
         (M_PI * std::pow(3. * dx, 5));
}

std::ptrdiff_t only_point(const PeridynamicBody &body)
{
  return body.lattice().index(0, 0, 0);
}

void step(Bodies &bodies, ShortRangeContact &debris, const double dt, const bool breaking = false)
{
  for (const auto &body : bodies)
  {
    body->update_ghosts();
    body->evaluate(breaking, false);
  }
  debris.evaluate(dt);
}

void advance(Bodies &bodies, const double dt)
{
  for (const auto &body : bodies)
    body->advance(dt, dt);
}

TEST(ShortRangeContact, PointsOfTwoBodiesRepelByTheStatedLaw)
{
  Bodies bodies;
  bodies.push_back(one_point(0, {0., 0., 0.}));
  bodies.push_back(one_point(1, {3. * dx, 0., 0.}));
  const double factor = 0.7;
  ShortRangeContact debris(MPI_COMM_SELF, bodies, factor, /*mirrored=*/false);
  const auto p = only_point(*bodies[0]), q = only_point(*bodies[1]);
  const double d  = 1.35 * dx; // min(0.9 * 3 dx, 1.35 dx)
  const Vector3 n = Vector3(1., 2., -1.).normalized();
  for (const double r : {2. * dx, 1.36 * dx, 1.3 * dx, dx, 0.2 * dx})
  {
    set(bodies[1]->state().arrays.position, q, position(*bodies[0], p) + r * n);
    // A fast body makes the next evaluation search again.
    set(bodies[1]->state().arrays.velocity, q, Vector3(1e6, 0., 0.));
    step(bodies, debris, 1e-6);
    const double overlap = std::max(0., d - r), k = pair_stiffness(*bodies[0], factor);
    EXPECT_LT((force(*bodies[1], q) - k * overlap * n).norm(), 1e-12 * k * d);
    EXPECT_EQ(force(*bodies[0], p), Vector3(-force(*bodies[1], q))); // momentum, exactly
    EXPECT_NEAR(debris.energy(), 0.5 * k * overlap * overlap, 1e-12 * k * d * d);
  }
}

TEST(ShortRangeContact, NormalForceIsTheGradientOfTheStoredEnergy)
{
  Bodies bodies;
  bodies.push_back(one_point(0, {0., 0., 0.}));
  bodies.push_back(one_point(1, {3. * dx, 0., 0.}));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false);
  const auto q = only_point(*bodies[1]);
  const Vector3 x(0.6 * dx, 0.5 * dx, -0.4 * dx);
  const double h = 1e-6 * dx; // truncation h^2, rounding 1e-16/1e-6
  set(bodies[1]->state().arrays.position, q, x);
  step(bodies, debris, 1e-9);
  const Vector3 f = force(*bodies[1], q);
  ASSERT_GT(f.norm(), 0.);
  for (int axis = 0; axis < 3; ++axis)
  {
    double energy[2];
    for (const int side : {0, 1})
    {
      set(bodies[1]->state().arrays.position, q, x + (side ? h : -h) * Vector3::Unit(axis));
      step(bodies, debris, 1e-9);
      energy[side] = debris.energy();
    }
    EXPECT_NEAR(f[axis], -(energy[1] - energy[0]) / (2. * h), 1e-8 * f.norm());
  }
}

TEST(ShortRangeContact, HeadOnCollisionExchangesTheVelocities)
{
  const double v = 50.;
  double error[2];
  for (const int halving : {0, 1})
  {
    Bodies bodies;
    bodies.push_back(one_point(0, {0., 0., 0.}));
    bodies.push_back(one_point(1, {3. * dx, 0., 0.}));
    ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false);
    const auto p = only_point(*bodies[0]), q = only_point(*bodies[1]);
    auto &a = bodies[0]->state().arrays, &b = bodies[1]->state().arrays;
    set(a.velocity, p, {v, 0., 0.});
    // Both at rest relative to their centre of mass would be a special case: one hits the other at
    // rest.
    const double omega = std::sqrt(2. * pair_stiffness(*bodies[0], 1.) / bodies[0]->point_mass());
    const double dt    = 0.1 / omega / (1 << halving);
    double deepest     = 1.;
    for (int i = 0; i < 4. * dx / v / dt; ++i)
    {
      step(bodies, debris, dt);
      const Vector3 momentum = at(a.velocity, p) + at(b.velocity, q);
      EXPECT_LT((momentum - Vector3(v, 0., 0.)).norm(), 1e-14 * v); // rounding, every step
      deepest = std::min(deepest, (position(*bodies[1], q) - position(*bodies[0], p)).norm() / dx);
      advance(bodies, dt);
    }
    EXPECT_LT(deepest, 1.3) << "they must have met";
    EXPECT_EQ(debris.energy(), 0.);
    error[halving] = std::abs(at(b.velocity, q).x() / v - 1.);
    EXPECT_NEAR(at(a.velocity, p).x() / v, 0., 0.01);
  }
  // Leapfrog is exact within the contact's harmonic motion; entering and leaving cost (omega
  // dt)^2/2 = 0.005 at worst.
  EXPECT_LT(error[0], 0.005);
  EXPECT_LT(error[1], 0.005 / 4.);
}

TEST(ShortRangeContact, DebrisFlyingAtTheSymmetryPlaneBouncesOffItsImage)
{
  BodySample sample;
  sample.family.horizon_ratio = 1.5; // reaches the next point only
  sample.n                    = {1, 4, 1};
  sample.mirror_y             = true;
  sample.critical_stretch     = 0.01;
  Bodies bodies;
  bodies.push_back(make_body(sample));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., /*mirrored=*/true);
  auto &body = *bodies[0];
  auto &a    = body.state().arrays;
  // Far from each other all bonds break; then only the image is near.
  for (int y = 0; y < 4; ++y)
    set(a.position, body.lattice().index(0, y, 0), Vector3(20. * dx * y, 4. * dx, 0.));
  // y = 3 was never bonded with its image (foreign pair); y = 0 was (bond pair).
  for (const int y : {3, 0})
  {
    const auto p = body.lattice().index(0, y, 0);
    const Vector3 v(3., -40., 7.);
    set(a.velocity, p, v);
    const double k  = debris.squared_frequency(body) * body.point_mass() / 12.;
    const double dt = 0.05 / std::sqrt(4. * k / body.point_mass());
    double nearest = 1., most_energy = 0.;
    for (int i = 0; i < 8. * dx / 40. / dt; ++i)
    {
      step(bodies, debris, dt, /*breaking=*/true);
      nearest     = std::min(nearest, position(body, p).y());
      most_energy = std::max(most_energy, debris.energy());
      advance(bodies, dt);
    }
    ASSERT_TRUE(body.is_damaged(p));
    EXPECT_LT((at(a.velocity, p) - Vector3(3., 40., 7.)).norm(), 0.002 * 40.)
        << "(omega dt)^2/2 = 0.00125 at worst";
    EXPECT_GT(nearest, 0.);
    // At the turning point all of m v_y^2 (both halves) is in the contact of the point with its
    // image.
    EXPECT_NEAR(most_energy, body.point_mass() * 40. * 40., 0.01 * body.point_mass() * 40. * 40.);
    set(a.velocity, p, Vector3::Zero());
  }
}

TEST(ShortRangeContact, DebrisAcrossTheSymmetryPlaneMeetsImagesFarBehindIt)
{
  // A point that has crossed the plane, y = -2 dx, and the image of another at y = -3 dx: the force
  // on either must be what it does to the other one's image. Images were once only made near the
  // plane.
  BodySample sample;
  sample.family.horizon_ratio = 1.5;
  sample.n                    = {6, 4, 1};
  sample.mirror_y             = true;
  sample.critical_stretch     = 0.01;
  Bodies bodies;
  bodies.push_back(make_body(sample));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., true);
  auto &body = *bodies[0];
  auto &a    = body.state().arrays;
  int n      = 0;
  for_each_point(body, [&](const std::ptrdiff_t i)
                 { set(a.position, i, Vector3(20. * dx * ++n, 50. * dx, 0.)); });
  const auto p = body.lattice().index(0, 0, 0), q = body.lattice().index(5, 3, 0);
  set(a.position, p, Vector3(0., -2. * dx, 0.));
  set(a.position, q, Vector3(0.5 * dx, 3. * dx, 0.));
  step(bodies, debris, 1e-9, /*breaking=*/true);
  EXPECT_GT(force(body, p).norm(), 0.);
  EXPECT_EQ(force(body, p).x(), -force(body, q).x());
  EXPECT_EQ(force(body, p).y(),
            force(body, q).y()); // the image of q pushes p towards positive y, as q's reaction says
}

TEST(ShortRangeContact, DebrisAcrossTheSymmetryPlaneMeetsTheImageOfIntactSurface)
{
  // One corner point is torn off a plate and lies beside the image of the plate's far edge, which
  // is undamaged and nowhere near any debris on its own side.
  BodySample sample;
  sample.family.horizon_ratio = 1.5;
  sample.n                    = {6, 8, 1};
  sample.mirror_y             = true;
  sample.critical_stretch     = 0.01;
  Bodies bodies;
  bodies.push_back(make_body(sample));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., true);
  auto &body   = *bodies[0];
  const auto p = body.lattice().index(0, 0, 0), q = body.lattice().index(3, 7, 0);
  const Vector3 far = reference(body, q);
  set(body.state().arrays.position, p, Vector3(far.x(), -far.y(), far.z() + 0.8 * dx));
  step(bodies, debris, 1e-9, /*breaking=*/true);
  ASSERT_FALSE(body.is_damaged(q));
  EXPECT_GT(force(body, p).z(), 0.);
  // The edge's other points push and are pushed as well; together they get what the debris gets.
  double sum = 0.;
  for_each_point(body, [&](const std::ptrdiff_t i) { sum += force(body, i).z(); });
  EXPECT_NEAR(sum, 0., 1e-12 * force(body, p).z());
  EXPECT_LT(force(body, q).z(), 0.);
}

TEST(ShortRangeContact, StackedPlatesAtRestDoNotFeelEachOther)
{
  for (const double gap : {0., 0.5, 1., 2.}) // in spacings; surface points are gap + 1 apart
  {
    Bodies bodies;
    for (const int number : {0, 1})
    {
      BodySample sample;
      sample.n      = {6, 5, 4};
      sample.number = number;
      sample.corner = {0., 0., -number * (4. + gap) * dx};
      bodies.push_back(make_body(sample));
    }
    ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false);
    step(bodies, debris, 1e-7);
    EXPECT_EQ(debris.energy(), 0.) << gap;
    for (const auto &body : bodies)
      for_each_point(*body,
                     [&](const std::ptrdiff_t p)
                     {
                       // Only the rounding of the bonds; a strain of one would be thousands of
                       // newtons.
                       EXPECT_LT(force(*body, p).norm(), 1e-9);
                     });
  }
}

TEST(ShortRangeContact, PlatesPushedTogetherShareOneMomentum)
{
  Bodies bodies;
  for (const int number : {0, 1})
  {
    BodySample sample;
    sample.n      = {6, 5, 4};
    sample.number = number;
    sample.corner = {0., 0., -number * 4. * dx};
    bodies.push_back(make_body(sample));
  }
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false);
  // The lower plate rises by a third of a spacing and shifts a little.
  for_each_point(*bodies[1],
                 [&](const std::ptrdiff_t p)
                 {
                   set(bodies[1]->state().arrays.position, p,
                       reference(*bodies[1], p) + Vector3(0.2 * dx, 0.1 * dx, dx / 3.));
                 });
  step(bodies, debris, 1e-7);
  Vector3 sum[2] = {Vector3::Zero(), Vector3::Zero()}, moment = Vector3::Zero();
  double total = 0.;
  for (const int i : {0, 1})
    for_each_point(*bodies[i],
                   [&](const std::ptrdiff_t p)
                   {
                     sum[i] += force(*bodies[i], p);
                     moment += position(*bodies[i], p).cross(force(*bodies[i], p));
                     total += force(*bodies[i], p).norm();
                   });
  EXPECT_GT(sum[0].z(), 0.1 * total);
  EXPECT_LT((sum[0] + sum[1]).norm(), 1e-13 * total);
  EXPECT_LT(moment.norm(), 1e-13 * total * 10. * dx);
}

/// Two bodies of one point each that overlap: the first at the origin, the second 1.2 dx away.
struct Pair
{
  explicit Pair(const ShortRangeContact::Friction &friction, const double second_density = 0.)
  {
    bodies.push_back(one_point(0, Vector3::Zero()));
    BodySample sample;
    sample.n      = {1, 1, 1};
    sample.corner = 3. * dx * n - Vector3::Constant(0.5 * dx);
    sample.number = 1;
    if (second_density > 0.)
      sample.family.law.density = second_density;
    bodies.push_back(make_body(sample));
    debris = std::make_unique<ShortRangeContact>(MPI_COMM_SELF, bodies, 1., false, "linked cells",
                                                 friction);
    p      = only_point(*bodies[0]);
    q      = only_point(*bodies[1]);
    set(bodies[1]->state().arrays.position, q, Vector3(1.2 * dx * n));
  }

  Vector3 n     = Vector3(1., 2., -1.).normalized();
  Vector3 along = Vector3(1., 1., 3.).normalized(); // n . along = 0
  Bodies bodies;
  std::unique_ptr<ShortRangeContact> debris;
  std::ptrdiff_t p, q;
};

TEST(ShortRangeContact, PointsOfTwoBodiesRubByTheStatedLaw)
{
  const ExponentialFriction law({0.5, 0.05, 0.01});
  const double factor = 0.8, v_reg = 5., dt = 1e-9; // too short to be stopped in
  Pair pair({&law, factor, v_reg});
  const double f_n = 0.15 * dx * pair_stiffness(*pair.bodies[0], 1.); // 1.35 dx - 1.2 dx
  for (const double speed : {300., 40., 5., 2., 0.})
  {
    const Vector3 common(11., -7., 5.); // of both: changes nothing
    set(pair.bodies[0]->state().arrays.velocity, pair.p, common);
    set(pair.bodies[1]->state().arrays.velocity, pair.q,
        Vector3(common + speed * pair.along - 30. * pair.n));
    step(pair.bodies, *pair.debris, dt);
    // mu f_n v_t/|v_t|, with v_t/v_reg below the regularisation speed.
    const double expected = factor * law.coefficient(speed) * f_n * std::min(speed / v_reg, 1.);
    const Vector3 f       = force(*pair.bodies[1], pair.q);
    EXPECT_NEAR(f.dot(pair.n), f_n, 1e-12 * f_n) << speed;
    EXPECT_LT((f - f_n * pair.n + expected * pair.along).norm(), 1e-12 * f_n) << speed;
    EXPECT_EQ(force(*pair.bodies[0], pair.p), Vector3(-f)); // momentum, exactly
  }
}

TEST(ShortRangeContact, FrictionNeverDrivesPointsBack)
{
  const ConstantFriction law({100.});
  Pair pair({&law, 1., 1.}, /*second_density=*/5000.);
  auto &a = pair.bodies[0]->state().arrays, &b = pair.bodies[1]->state().arrays;
  set(b.velocity, pair.q, Vector3(10. * pair.along));
  const double dt = 1e-7;
  double before   = 10.;
  for (int i = 0; i < 12; ++i)
  {
    step(pair.bodies, *pair.debris, dt);
    for (const auto &body : pair.bodies)
      body->advance(dt, 0.); // they stay where they are
    const double sliding = (at(b.velocity, pair.q) - at(a.velocity, pair.p)).dot(pair.along);
    // The strongest friction leaves 5/6 of the sliding after each step, whatever the masses.
    EXPECT_NEAR(sliding, 5. / 6. * before, 1e-12 * before);
    before = sliding;
  }
}

TEST(ShortRangeContact, HeatOfFrictionIsTheEnergyThatACollisionLoses)
{
  const ConstantFriction law({0.3});
  Bodies bodies;
  bodies.push_back(one_point(0, {0., 0., 0.}));
  bodies.push_back(one_point(1, {3. * dx, 0., 0.}));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false, "linked cells", {&law, 1., 1.});
  const auto p = only_point(*bodies[0]), q = only_point(*bodies[1]);
  auto &a = bodies[0]->state().arrays, &b = bodies[1]->state().arrays;
  set(a.position, p, Vector3(0., -0.5 * dx, 0.));
  set(a.velocity, p, Vector3(50., 5., 20.));
  const double mass  = bodies[0]->point_mass();
  const auto kinetic = [&]
  { return 0.5 * mass * (at(a.velocity, p).squaredNorm() + at(b.velocity, q).squaredNorm()); };
  const double initial = kinetic();
  const double dt      = 0.02 / std::sqrt(2. * pair_stiffness(*bodies[0], 1.) / mass);
  for (int i = 0; i < 5. * dx / 50. / dt; ++i)
  {
    step(bodies, debris, dt);
    advance(bodies, dt);
    debris.record_work(dt);
    const Vector3 momentum = at(a.velocity, p) + at(b.velocity, q);
    EXPECT_LT((momentum - Vector3(50., 5., 20.)).norm(), 1e-13 * 50.);
  }
  EXPECT_EQ(debris.energy(), 0.) << "they must have parted";
  EXPECT_GT(at(b.velocity, q).norm(), 10.) << "they must have met";
  const double heat = -debris.friction_work();
  EXPECT_GT(heat, 0.01 * initial);
  // Entering and leaving contact between two steps costs (omega dt)^2/2 = 0.0002 at worst.
  EXPECT_NEAR(initial - kinetic(), heat, 2e-4 * initial);
}

TEST(ShortRangeContact, FactorZeroSwitchesItOff)
{
  Bodies bodies;
  bodies.push_back(one_point(0, {0., 0., 0.}));
  bodies.push_back(one_point(1, {3. * dx, 0., 0.}));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 0., false);
  const auto q = only_point(*bodies[1]);
  set(bodies[1]->state().arrays.position, q, Vector3(0.5 * dx, 0., 0.));
  step(bodies, debris, 1e-7);
  EXPECT_EQ(force(*bodies[1], q), Vector3::Zero());
  EXPECT_EQ(debris.energy(), 0.);
  EXPECT_EQ(debris.squared_frequency(*bodies[0]), 0.);
}

TEST(ShortRangeContact, SearchFindsBodiesThatMeetLongAfterTheFirstSearch)
{
  // Fast enough to cross the skin in 20 steps, far enough to need several searches.
  Bodies bodies;
  bodies.push_back(one_point(0, {0., 0., 0.}));
  bodies.push_back(one_point(1, {15. * dx, 0.4 * dx, 0.}));
  ShortRangeContact debris(MPI_COMM_SELF, bodies, 1., false);
  const auto p = only_point(*bodies[0]), q = only_point(*bodies[1]);
  set(bodies[1]->state().arrays.velocity, q, Vector3(-100., 0., 0.));
  const double dt = 0.05 * dx / 100.;
  for (int i = 0; i < 400; ++i)
  {
    step(bodies, debris, dt);
    // Whatever the search does, the force is that of the positions.
    const Vector3 d      = position(*bodies[1], q) - position(*bodies[0], p);
    const double overlap = std::max(0., 1.35 * dx - d.norm()), k = pair_stiffness(*bodies[0], 1.);
    ASSERT_LT((force(*bodies[1], q) - k * overlap * d.normalized()).norm(), 1e-12 * k * dx)
        << "step " << i;
    advance(bodies, dt);
  }
  EXPECT_GT(at(bodies[0]->state().arrays.velocity, p).norm(), 1.) << "they must have met";
}
} // namespace
} // namespace ricochet::tests
