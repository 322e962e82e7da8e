// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/rigid_contact.h"
#include "support/body.h"
#include "support/verification.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
constexpr double dx = 1e-3;

const ConstantFriction::Parameters constant_friction{0.2};
const ConstantFriction::Parameters no_friction{0.};

/// A block of points whose upper layer has its centres at z = -dx/2: the upper face is z = 0, as
/// for a plate.
BodySample bed(const int nx, const int ny, const int nz = 1)
{
  BodySample sample;
  sample.n      = {nx, ny, nz};
  sample.corner = {-0.5 * nx * dx, -0.5 * ny * dx, -nz * dx};
  return sample;
}

RigidBody::Motion at(const Vector3 &position)
{
  return {position, Vector3::Zero(), Eigen::Quaterniond::Identity(), Vector3::Zero()};
}

const BodyOfRevolution core({NoseShape::ogive, 6e-3, 20e-3, 9e-3});

/// A core that ploughs through the upper points of a plate, tumbling; every kind of surface touches
/// something.
RigidBody ploughing_core()
{
  auto motion        = at({0., 0.3 * dx, 1.0 * dx});
  motion.orientation = Eigen::AngleAxisd(0.15, Vector3::UnitY());
  motion.velocity    = Vector3(200., -30., -60.);
  motion.spin        = Vector3(3000., -9000., 2000.);
  return RigidBody(core, 5e-3, motion, false);
}

void shake(PeridynamicBody &plate)
{
  Random random(47);
  auto &a = plate.state().arrays;
  for_each_point(plate,
                 [&](const std::ptrdiff_t p)
                 {
                   set(a.position, p, reference(plate, p) + 0.1 * dx * random.vector());
                   set(a.velocity, p, 50. * random.vector());
                   set(a.force, p, Vector3::Zero());
                 });
}

TEST(RigidContact, ForcesAndMomentsOnPointsAndProjectileCancel)
{
  for (const auto &friction : friction_law_samples)
  {
    const auto plate = make_body(bed(30, 12, 4));
    const auto law   = make_friction_law(friction);
    RigidContact contact(MPI_COMM_SELF, *law, {5e6, 40., 5.}, false, 30);
    const auto body = ploughing_core();
    shake(*plate);
    const auto reaction = contact.add_forces(body, *plate, 0.);
    Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
    double total = 0.;
    int n        = 0;
    for_each_point(*plate,
                   [&](const std::ptrdiff_t p)
                   {
                     sum += force(*plate, p);
                     moment +=
                         (position(*plate, p) - body.motion().position).cross(force(*plate, p));
                     total += force(*plate, p).norm();
                     n += force(*plate, p).norm() > 0.;
                   });
    EXPECT_GT(n, 20);
    EXPECT_EQ(reaction.n_touching, n);
    EXPECT_GT(reaction.friction.norm(), 0.);
    EXPECT_GT(reaction.shank.norm(), 0.) << "the shank must touch, too";
    EXPECT_LT((sum + reaction.force()).norm(), 1e-13 * total);
    EXPECT_LT((moment + reaction.moment).norm(), 1e-13 * total * 20e-3);
  }
}

TEST(RigidContact, NormalForceIsTheGradientOfTheStoredEnergy)
{
  const auto plate = make_body(bed(30, 12, 4));
  const auto law   = make_friction_law(no_friction);
  RigidContact contact(MPI_COMM_SELF, *law, {5e6, 0., 5.}, false, 30);
  shake(*plate);
  const auto start  = ploughing_core().motion();
  const auto energy = [&](const RigidBody::Motion &motion)
  { return contact.add_forces(RigidBody(core, 5e-3, motion, false), *plate, 0.).energy; };
  const auto reaction = contact.add_forces(RigidBody(core, 5e-3, start, false), *plate, 0.);
  // Half a spring's square per point; a point that begins to touch within h adds k h^2/2 only.
  const double h      = 1e-9;
  ASSERT_GT(reaction.normal.norm(), 1000.);
  EXPECT_EQ(reaction.friction.norm(), 0.);
  for (int d = 0; d < 3; ++d)
  {
    auto up = start, down = start;
    up.position += h * Vector3::Unit(d);
    down.position -= h * Vector3::Unit(d);
    EXPECT_NEAR(reaction.normal[d], -(energy(up) - energy(down)) / (2. * h),
                1e-5 * reaction.normal.norm());
    const double angle = 1e-7;
    up = down        = start;
    up.orientation   = Eigen::AngleAxisd(angle, Vector3::Unit(d)) * start.orientation;
    down.orientation = Eigen::AngleAxisd(-angle, Vector3::Unit(d)) * start.orientation;
    EXPECT_NEAR(reaction.moment[d], -(energy(up) - energy(down)) / (2. * angle),
                1e-5 * reaction.moment.norm());
  }
}

TEST(RigidContact, NormalForceIsStiffnessTimesDepth)
{
  // A flat face 0.2 dx deep in the spheres of diameter dx around the points.
  const auto plate = make_body(bed(4, 4));
  const auto law   = make_friction_law(no_friction);
  const BodyOfRevolution cylinder({NoseShape::flat, 40. * dx, 10. * dx, 0.});
  auto motion        = at({0., 0., 5. * dx - 0.2 * dx});
  motion.orientation = Eigen::AngleAxisd(M_PI / 2., Vector3::UnitY()); // axis down
  const double k     = 3e6;
  RigidContact contact(MPI_COMM_SELF, *law, {k, 0., 5.}, false, 4);
  const auto reaction = contact.add_forces(RigidBody(cylinder, 1., motion, false), *plate, 0.);
  EXPECT_EQ(reaction.n_touching, 16.);
  EXPECT_NEAR(reaction.deepest, 0.2 * dx, 1e-15);        // metres
  EXPECT_NEAR(reaction.deepest_in_spacings, 0.2, 1e-12); // and of its own name
  EXPECT_LT((reaction.normal - Vector3(0., 0., 16. * k * 0.2 * dx)).norm(), 1e-9 * k * dx);
  EXPECT_NEAR(reaction.energy, 16. * 0.5 * k * std::pow(0.2 * dx, 2), 1e-9 * k * dx * dx);
}

TEST(RigidContact, FrictionOpposesSlidingAndFallsLinearlyBelowTheRegularisationSpeed)
{
  for (const auto &friction : friction_law_samples)
  {
    const auto plate = make_body(bed(4, 4));
    const auto law   = make_friction_law(friction);
    const BodyOfRevolution cylinder({NoseShape::flat, 40. * dx, 10. * dx, 0.});
    auto motion        = at({0., 0., 5. * dx - 0.2 * dx});
    motion.orientation = Eigen::AngleAxisd(M_PI / 2., Vector3::UnitY());
    RigidContact contact(MPI_COMM_SELF, *law, {3e6, 0., 5.}, false, 4);
    const Vector3 direction = Vector3(3., -4., 0.) / 5.;
    for (const double speed : {0., 1e-3, 2.5, 5., 50., 500.})
    {
      motion.velocity = speed * direction - Vector3(0., 0., 20.); // closing speed is not sliding
      const auto reaction = contact.add_forces(RigidBody(cylinder, 1., motion, false), *plate, 0.);
      // mu(v) N v/|v|, with |v| replaced by 5 m/s below that.
      const double mu     = law->coefficient(speed);
      const Vector3 expected = -mu * reaction.normal.z() * std::min(1., speed / 5.) * direction;
      EXPECT_LT((reaction.friction - expected).norm(), 1e-12 * reaction.normal.norm())
          << FrictionLaws::name(friction) << " at " << speed;
    }
  }
}

TEST(RigidContact, ShankResistanceActsOnTheShankOnly)
{
  auto sample             = bed(20, 6);
  sample.corner.x()       = -5. * dx; // in front of the base's edge, where normals tilt
  const auto plate        = make_body(sample);
  const auto law          = make_friction_law(constant_friction);
  const double resistance = 40.; // N per point, as fraction times A dx^2
  RigidContact contact(MPI_COMM_SELF, *law, {5e6, resistance, 5.}, false, 20);
  auto motion     = at({0., 0., 3e-3 - 0.3 * dx}); // lies on its shank
  motion.velocity = Vector3(100., 0., 0.);
  const RigidBody body(core, 5e-3, motion, false);
  const auto reaction = contact.add_forces(body, *plate, 0.);
  int on_shank        = 0;
  for_each_point(*plate,
                 [&](const std::ptrdiff_t p)
                 {
                   const auto hit = body.hit(position(*plate, p));
                   on_shank +=
                       hit.surface == BodyOfRevolution::Surface::shank && hit.distance < dx / 2.;
                 });
  EXPECT_GT(on_shank, 5);
  EXPECT_LT(on_shank, reaction.n_touching) << "points at the nose, too";
  EXPECT_NEAR(reaction.shank.x(), -0.2 * resistance * on_shank, 1e-10);
}

TEST(RigidContact, SymmetryPlaneDoublesForcesAndRemovesWhatItForbids)
{
  auto sample            = bed(30, 12, 4);
  auto half_sample       = sample;
  half_sample.n[1]       = 6;
  half_sample.corner.y() = 0.;
  half_sample.mirror_y   = true;
  const auto full = make_body(sample), half = make_body(half_sample);
  const auto law     = make_friction_law(constant_friction);
  auto motion        = at({0., 0., 1.0 * dx});
  motion.orientation = Eigen::AngleAxisd(0.15, Vector3::UnitY());
  motion.velocity    = Vector3(200., 0., -60.);
  motion.spin        = Vector3(0., -9000., 0.);
  const RigidBody body(core, 5e-3, motion, true);
  RigidContact on_full(MPI_COMM_SELF, *law, {5e6, 40., 5.}, false, 30),
      on_half(MPI_COMM_SELF, *law, {5e6, 40., 5.}, true, 30);
  const auto f = on_full.add_forces(body, *full, 0.), h = on_half.add_forces(body, *half, 0.);
  EXPECT_EQ(f.n_touching, h.n_touching);
  EXPECT_NEAR(f.energy, h.energy, 1e-13 * f.energy);
  EXPECT_LT((f.force() - h.force()).norm(), 1e-12 * f.force().norm());
  EXPECT_LT((f.moment - h.moment).norm(), 1e-12 * f.moment.norm());
  EXPECT_LT((f.friction_moment - h.friction_moment).norm(), 1e-12 * f.moment.norm());
  EXPECT_EQ(h.force().y(), 0.);
  EXPECT_EQ(h.moment.x(), 0.);
  EXPECT_EQ(h.moment.z(), 0.);
}

/// Work of friction on points and core in one step, pressed and shaken by forces that have nothing
/// to do with it.
double work_of_friction(const RigidBody &start, const double mu, const double dt,
                        const bool mirrored)
{
  auto sample = bed(30, 12, 4);
  if (mirrored)
  {
    sample.n[1]       = 6;
    sample.corner.y() = 0.;
    sample.mirror_y   = true;
  }
  const auto plate = make_body(sample);
  shake(*plate);
  Random random(11);
  auto &a = plate->state().arrays;
  for_each_point(*plate, [&](const std::ptrdiff_t p) { set(a.force, p, 3000. * random.vector()); });
  const auto law = make_friction_law(ConstantFriction::Parameters{mu});
  RigidContact contact(MPI_COMM_SELF, *law, {5e7, 40., 5.}, mirrored, 30);
  RigidBody body         = start;
  const auto reaction    = contact.add_forces(body, *plate, dt);
  const Vector3 friction = reaction.friction + reaction.shank;
  const auto before      = body.motion();
  plate->advance(dt, dt);
  contact.record_work(dt);
  body.advance(reaction.force(), reaction.moment, dt, dt);
  return contact.work_on_points() +
         0.5 * dt *
             (friction.dot(before.velocity + body.motion().velocity) +
              reaction.friction_moment.dot(before.spin + body.motion().spin));
}

TEST(RigidContact, FrictionGivesNoEnergyHoweverLargeItIs)
{
  // Normal forces and step are such that Coulomb's force alone would reverse the sliding a hundred
  // times; the core is as light as the points it touches, so that they move each other through it.
  for (const bool mirrored : {false, true})
    for (const double mass : {2e-5, 5e-3})
      for (const double mu : {0.3, 1., 20., 1e4})
        for (const double dt : {1e-9, 1e-7, 1e-6})
        {
          auto motion = ploughing_core().motion();
          if (mirrored)
            motion.velocity.y() = motion.spin.x() = motion.spin.z() = motion.position.y() = 0.;
          const double work =
              work_of_friction(RigidBody(core, mass, motion, mirrored), mu, dt, mirrored);
          EXPECT_LT(work, 0.) << mass << " kg, mu = " << mu << ", " << dt << " s";
        }
}

TEST(RigidContact, BlockSlidingOnAFlatFaceStopsWhereCoulombSays)
{
  // Stops after v0/(mu g) at v0^2/(2 mu g), 1 %. An elastic block of
  // points slides on the flat end of a large fixed cylinder; gravity is scaled up so that this
  // takes 2000 steps.
  auto sample      = bed(6, 6, 3);
  sample.corner    = {0., 0., -dx / 2.}; // the lowest points' spheres touch z = -dx/2 - dx/2 + dx/2
  const auto block = make_body(sample);
  auto &a          = block->state().arrays;
  const BodyOfRevolution cylinder({NoseShape::flat, 200. * dx, 20. * dx, 0.});
  auto motion        = at({0., 0., -10. * dx - 0.5 * dx}); // its upper face at z = -dx/2
  motion.orientation = Eigen::AngleAxisd(-M_PI / 2., Vector3::UnitY());
  const RigidBody ground(cylinder, 1., motion, false);

  const double mu = 0.2, v0 = 10., g = 3e4;
  const auto law = make_friction_law(ConstantFriction::Parameters{mu});
  const double k = youngs_modulus(block->material()) * dx;
  RigidContact contact(MPI_COMM_SELF, *law, {k, 0., /*regularisation_speed=*/0.02 * v0}, false, 6);
  const double depth = 3. * block->point_mass() * g / k; // three layers rest on each spring
  for_each_point(*block,
                 [&](const std::ptrdiff_t p)
                 {
                   set(a.position, p, reference(*block, p) - Vector3(0., 0., depth));
                   set(a.velocity, p, Vector3(v0, 0., 0.));
                 });
  const double limit =
      2.02 * dx / std::sqrt(p_wave_modulus(block->material()) / block->material().density);
  const double dt = 0.4 * limit;
  const auto mean = [&](double *const field[3])
  {
    Vector3 sum = Vector3::Zero();
    for_each_point(*block, [&](const std::ptrdiff_t p) { sum += tests::at(field, p); });
    return Vector3(sum / (6 * 6 * 3));
  };
  const double start = mean(a.position).x();
  double tenth       = 0.; // when a tenth of the speed is left
  for (int i = 0; i * dt < 1.5 * v0 / (mu * g); ++i)
  {
    block->update_ghosts();
    block->compute_internal_forces({false});
    contact.add_forces(ground, *block, dt);
    for_each_point(*block,
                   [&](const std::ptrdiff_t p) { a.force[2][p] -= block->point_mass() * g; });
    if (tenth == 0. && mean(a.velocity).x() < 0.1 * v0)
      tenth = i * dt;
    block->advance(dt, dt);
    contact.record_work(dt);
  }
  verify_near("V19", "time to a tenth of the speed over v₀/(μg)", tenth / (v0 / (mu * g)), 0.9,
              0.01);
  verify_near("V19", "way to rest over v₀²/(2μg)",
              (mean(a.position).x() - start) / (v0 * v0 / (2. * mu * g)), 1., 0.01);
  EXPECT_LT(mean(a.velocity).norm(), 1e-3 * v0);
  // The ledger: friction has eaten the kinetic energy (what vibrates is below a per cent).
  const double kinetic = 0.5 * 108 * block->point_mass() * v0 * v0;
  EXPECT_NEAR(contact.work_on_points(), -kinetic, 0.01 * kinetic);
}

constexpr double R =
    50. * dx; // of the sphere: large against the points, which are spheres themselves

/// A rigid sphere above a bed of points which do not move.
struct BallOnBed
{
  BallOnBed(const int n_along, const double mass, const double stiffness, const double mu,
            const double regularisation_speed, const Vector3 &start, const Vector3 &velocity) :
    plate(make_body(
        [&]
        {
          auto sample           = bed(n_along, 24);
          sample.corner.x()     = -20. * dx;
          sample.density_factor = 1e9; // friction must not believe that it could move them
          return sample;
        }())),
    law(make_friction_law(ConstantFriction::Parameters{mu})),
    contact(MPI_COMM_SELF, *law, {stiffness, 0., regularisation_speed}, false, n_along),
    ball(BodyOfRevolution({NoseShape::sphere, 2. * R, 0., 0.}), mass,
         {start, velocity, Eigen::Quaterniond::Identity(), Vector3::Zero()}, false)
  {
  }

  ContactRecord step(const double dt, const double weight)
  {
    for_each_point(*plate, [&](const std::ptrdiff_t p)
                   { set(plate->state().arrays.force, p, Vector3::Zero()); });
    const auto reaction = contact.add_forces(ball, *plate, dt);
    ball.advance(reaction.force() - Vector3(0., 0., weight), reaction.moment, dt, dt);
    return reaction;
  }

  std::unique_ptr<PeridynamicBody> plate;
  std::unique_ptr<FrictionLaw> law;
  RigidContact contact;
  RigidBody ball;
};

TEST(RigidContact, SphereSlidesThenRollsAtFiveSeventhsOfItsSpeed)
{
  // v = 5/7 v0 after 2 v0/(7 mu g).
  const double v0 = 10., mu = 0.2, g = 2000., mass = 1.;
  // Sunk in by 0.3 dx it rests on about 90 points; the stiffness follows from the weight.
  const double sunk = 0.3 * dx;
  BallOnBed probe(120, mass, 1., mu, 0.01 * v0, {0., 0., R - sunk}, Vector3::Zero());
  const double stiffness =
      mass * g / probe.contact.add_forces(probe.ball, *probe.plate, 0.).normal.z();
  BallOnBed test(120, mass, stiffness, mu, 0.01 * v0, {0., 0., R - sunk}, {v0, 0., 0.});

  const double rolling = 2. * v0 / (7. * mu * g);
  const double dt      = rolling / 1500;
  double stuck         = 0.; // when slip has fallen to a tenth
  for (int i = 0; i < 1950; ++i)
  {
    test.step(dt, mass * g);
    const auto &m = test.ball.motion();
    if (stuck == 0. && m.velocity.x() - m.spin.y() * R < 0.1 * v0)
      stuck = test.ball.motion().position.x() > 0. ? i * dt : 0.;
  }
  const auto &m = test.ball.motion();
  // The forces act at the points' centres, dx/2 = 1 % of R outside the sphere, which shortens both
  // a little.
  verify_near("V20", "speed of the rolling sphere over v₀", m.velocity.x() / v0, 5. / 7., 0.01);
  EXPECT_NEAR(m.spin.y() * R, m.velocity.x(), 0.02 * v0);
  // Slip falls linearly.
  verify_near("V20", "time to a tenth of the slip over 2v₀/(7μg)", stuck / rolling, 0.9, 0.02);
  EXPECT_NEAR(m.velocity.y(), 0., 1e-3 * v0);
}

TEST(RigidContact, ObliqueReboundInGrossSlipHasTheImpulseOfCoulomb)
{
  // dv_t = -mu (1 + e) v_n, spin 5 mu (1 + e) v_n/(2 R); gross slip while
  // tan(alpha) > 3.5 mu (1 + e) = 1.4. The springs store and return everything: e = 1.
  const double mu = 0.2, v_n = 5., v_t = 3. * v_n, mass = 1.;
  // Deepest point sqrt(m/k_total) v_n: 0.5 dx on about 150 points.
  const double stiffness = 1e6;
  BallOnBed test(60, mass, stiffness, mu, /*regularisation_speed=*/0.005 * v_t,
                 {0., 0., R + 0.001 * dx}, {v_t, 0., -v_n});
  const double dt = 1e-7;
  double deepest  = 0.;
  for (int i = 0; i < 20000 && (test.ball.motion().velocity.z() < 0. || deepest == 0. ||
                                test.ball.motion().position.z() < R);
       ++i)
    deepest = std::max(deepest, test.step(dt, 0.).deepest);
  const auto &m = test.ball.motion();
  EXPECT_GT(deepest, 0.2 * dx);
  EXPECT_LT(deepest, 0.9 * dx); // one layer of points
  EXPECT_NEAR(m.velocity.z(), v_n, 0.002 * v_n);
  verify_near("V21", "change of the tangential velocity over -2μvₙ",
              (m.velocity.x() - v_t) / (-mu * 2. * v_n), 1., 0.02);
  verify_near("V21", "spin over 5μvₙ/R", m.spin.y() / (5. * mu * 2. * v_n / (2. * R)), 1., 0.02);
}
} // namespace
} // namespace ricochet::tests
