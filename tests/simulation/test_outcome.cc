// SPDX-License-Identifier: LGPL-2.1-or-later
// The verdict on projectiles that pass through plates as light as air, bounce off plates that never
// break, and come to rest.
#include "ricochet/simulation/outcome.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
using namespace units;

/// Plates that let everything through: the projectile keeps its velocity to a thousandth.
Scene airy(Scene scene)
{
  scene.materials[0].density       = 1.;
  scene.materials[0].bulk_modulus  = 5.9 * MPa;
  scene.materials[0].shear_modulus = 2.258 * MPa;
  scene.contact.stiffness_factor   = 0.01;
  scene.contact.debris_factor      = 0.;
  scene.contact.shank_resistance   = 0.;
  scene.time.free_time             = 2. * us;
  return scene;
}

/// Plates that never break.
Scene unbreakable_plate(Scene scene)
{
  scene.materials[0].critical_stretch = 10.;
  scene.contact.friction              = ConstantFriction::Parameters{0.};
  scene.contact.shank_resistance      = 0.;
  scene.time.free_time                = 2. * us;
  return scene;
}

/// Runs until the outcome is decided, or to `end_time` [s].
class Watched
{
public:
  explicit Watched(const Scene &scene, const double end_time = 400. * us) :
    simulation(MPI_COMM_SELF, scene), watch(simulation)
  {
    for (;;)
    {
      simulation.evaluate(false);
      watch.update();
      if (watch.decided() || simulation.time() >= end_time)
        break;
      simulation.advance();
    }
  }

  Simulation simulation;
  OutcomeWatch watch;
};

TEST(Outcome, ThroughTheRearFaceIsPerforation)
{
  for (const bool stack : {false, true})
  {
    Scene scene                  = airy(stack ? two_plates() : small_scene());
    scene.impact.incidence_angle = 90. * deg;
    scene.impact.entry_x         = 15. * mm;
    const Watched run(scene);
    ASSERT_TRUE(run.watch.decided());
    const auto verdict = run.watch.verdict("not asked");
    EXPECT_EQ(verdict.outcome, Outcome::perforate);
    EXPECT_EQ(verdict.exit_face, "rear");
    EXPECT_EQ(verdict.exit_plate, stack ? 2 : 1);
    EXPECT_NE(verdict.reason.find(stack ? "rear face of plate 2" : "rear face and"),
              std::string::npos)
        << verdict.reason;
    // It flies straight at 300 m/s.
    const double time = run.simulation.time();
    EXPECT_NEAR(run.watch.path(), 300. * time, 0.001 * 300. * time);
    // From the first to the last touch: the thickness and the projectile's length of 10 mm; points
    // are spheres, and some are pushed aside at either end.
    const double thickness = stack ? 8. * mm : 9. * mm;
    EXPECT_NEAR(run.watch.contact_duration(), (thickness + 10. * mm) / 300., 1.5 * mm / 300.);
    // The tip ends a length, the way of the free time and the last step below the rear face.
    EXPECT_GT(run.watch.max_depth(), thickness + 10. * mm);
    EXPECT_LT(run.watch.max_depth(), thickness + 10. * mm + 300. * 2. * us + 1.5 * mm);
  }
}

TEST(Outcome, OverAnEdgeItTellsTheOneOfWhichPlate)
{
  // Two plates of 4 mm, 30 mm long; at 30 degrees the centre falls by 0.58 mm in a millimetre and
  // passes the edge 1.6 mm or 5.6 mm deep.
  for (const auto &[entry, plate] : {std::pair<double, int>{25. * mm, 1}, {18. * mm, 2}})
  {
    Scene scene          = airy(two_plates());
    scene.impact.entry_x = entry;
    const Watched run(scene);
    ASSERT_TRUE(run.watch.decided());
    const auto verdict = run.watch.verdict("not asked");
    EXPECT_EQ(verdict.outcome, Outcome::edge) << verdict.reason;
    EXPECT_EQ(verdict.exit_face, "edge");
    EXPECT_EQ(verdict.exit_plate, plate);
    EXPECT_NE(verdict.reason.find("edge of plate " + std::to_string(plate)), std::string::npos);
    EXPECT_STREQ(name_of(verdict.outcome), "edge");
  }
}

TEST(Outcome, OffThePlateIsRicochet)
{
  Scene scene                  = unbreakable_plate(small_scene());
  scene.impact.incidence_angle = 10. * deg;
  const Watched run(scene);
  ASSERT_TRUE(run.watch.decided());
  const auto verdict = run.watch.verdict("not asked");
  EXPECT_EQ(verdict.outcome, Outcome::ricochet) << verdict.reason;
  EXPECT_EQ(verdict.exit_face, "front");
  EXPECT_EQ(verdict.exit_plate, 1);
  EXPECT_GT(run.simulation.projectile().motion().velocity.z(), 0.);
  EXPECT_GT(run.watch.contact_duration(), 0.);
}

TEST(Outcome, PastTheTargetIsUndecided)
{
  Scene scene                  = airy(small_scene());
  scene.impact.incidence_angle = 10. * deg;
  scene.impact.entry_x         = 29. * mm;
  scene.impact.clearance       = 3. * mm;
  const Watched run(scene);
  ASSERT_TRUE(run.watch.decided());
  const auto verdict = run.watch.verdict("not asked");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_EQ(verdict.exit_plate, 0);
  EXPECT_NE(verdict.reason.find("missed"), std::string::npos) << verdict.reason;
  EXPECT_EQ(run.watch.contact_duration(), 0.);
}

TEST(Outcome, AtRestIsStuck)
{
  // On soft springs it turns round slowly: it stays below a hundredth of its speed for 0.02
  // sqrt(m/k), longer than the free time.
  Scene scene                    = unbreakable_plate(small_scene());
  scene.contact.stiffness_factor = 1e-3;
  scene.projectile.mass          = 0.1 * g;
  scene.impact.speed             = 1.;
  scene.impact.incidence_angle   = 90. * deg;
  scene.impact.entry_x           = 15. * mm;
  scene.impact.clearance         = 0.01 * mm;
  scene.time.free_time           = 0.8 * us;
  const Watched run(scene, 1000. * us);
  ASSERT_TRUE(run.watch.decided());
  const auto verdict = run.watch.verdict("not asked");
  EXPECT_EQ(verdict.outcome, Outcome::stuck) << verdict.reason;
  EXPECT_EQ(verdict.exit_face, "none");
  EXPECT_EQ(verdict.exit_plate, 0);
  EXPECT_LT(run.simulation.projectile().motion().velocity.norm(), 0.01 * scene.impact.speed);
}

TEST(Outcome, CutShortItIsJudgedByTheCentre)
{
  Scene scene                  = airy(small_scene());
  scene.impact.incidence_angle = 90. * deg;
  scene.impact.entry_x         = 15. * mm;
  // The centre of the core lies 5 mm or so behind its tip and passes the rear face after about
  // (9 + 5) mm at 300 m/s, 47 us; the base leaves at 64 us.
  const Watched inside(scene, 30. * us), leaving(scene, 58. * us);
  ASSERT_FALSE(inside.watch.decided());
  ASSERT_FALSE(leaving.watch.decided());
  EXPECT_EQ(inside.watch.verdict("time is up").outcome, Outcome::undecided);
  EXPECT_EQ(inside.watch.verdict("time is up").reason, "time is up");
  EXPECT_EQ(inside.watch.verdict("time is up").exit_plate, 0);
  const auto verdict = leaving.watch.verdict("time is up");
  EXPECT_EQ(verdict.outcome, Outcome::perforate);
  EXPECT_EQ(verdict.exit_plate, 1);
  EXPECT_NE(verdict.reason.find("time is up"), std::string::npos);
  EXPECT_NE(verdict.reason.find("centre outside"), std::string::npos);
}
} // namespace
} // namespace ricochet::tests
