// SPDX-License-Identifier: LGPL-2.1-or-later
// The verdict on projectiles that pass through plates as light as air, bounce off plates that never
// break, and come to rest.
#include "ricochet/simulation/observation.h"
#include "ricochet/simulation/outcome.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <set>

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
    simulation(MPI_COMM_SELF, scene), watch(watch_of(simulation))
  {
    for (;;)
    {
      simulation.compute_forces(false);
      watch.update(observe(simulation));
      if (watch.decided() || simulation.time() >= end_time)
        break;
      simulation.advance();
    }
  }

  Simulation simulation;
  OutcomeWatch watch;
};

/// A point-like projectile, 1 mm in size, and plates 100 mm x 60 mm x 10 mm one below the other,
/// told what they do.
struct Story
{
  explicit Story(const int n_plates = 1, const double free_time = 5. * us) :
    watch(places(n_plates), 100., free_time), plates(places(n_plates))
  {
  }

  static std::vector<PlatePlace> places(const int n_plates)
  {
    std::vector<PlatePlace> all;
    for (int i = 0; i < n_plates; ++i)
      all.push_back({Vector3(0., -30., -10. * (i + 1)) * mm, Vector3(100., 30., -10. * i) * mm});
    return all;
  }

  /// For `duration` [s], in steps of 0.5 us; stops when the outcome is decided.
  void fly(const Vector3 &velocity, const double duration, const bool touching)
  {
    const double dt = 0.5 * us;
    for (double t = 0.; t < duration && !watch.decided(); t += dt)
    {
      watch.update(
          {time,
           position,
           velocity,
           {position - Vector3::Constant(0.5 * mm), position + Vector3::Constant(0.5 * mm)},
           touching,
           [this] { return plates; }});
      time += dt;
      position += dt * velocity;
      for (auto &plate : plates)
      {
        plate.low += dt * plate.velocity;
        plate.high += dt * plate.velocity;
      }
    }
  }

  OutcomeWatch watch;
  std::vector<PlatePlace> plates;
  Vector3 position = Vector3(50., 0., 1.) * mm;
  double time      = 0.;
};

TEST(Outcome, IsThatOfTheStepThatDecidedIt)
{
  Story story;
  story.fly({0., 0., -100.}, 5. * us, true);
  story.fly({0., 0., 100.}, 20. * us, false);
  ASSERT_TRUE(story.watch.decided());
  story.plates[0].high.z() += 5. * mm; // swings on before anybody asks
  EXPECT_EQ(story.watch.verdict("not asked").outcome, Outcome::ricochet);
}

TEST(Outcome, TurningRoundIsNoRest)
{
  // In and out again, as on a spring: slow at the turn, whatever the free time.
  for (const double free_time : {1. * us, 5. * us, 50. * us})
  {
    Story story(1, free_time);
    for (int i = -500; i <= 500; ++i)
      story.fly({0., 0., 100. * std::sin(M_PI / 2. * i / 500.)}, 0.5 * us, true);
    EXPECT_FALSE(story.watch.decided());
    story.fly({0., 0., 100.}, 2000. * us, false);
    ASSERT_TRUE(story.watch.decided());
    EXPECT_EQ(story.watch.verdict("").outcome, Outcome::ricochet);
  }
}

TEST(Outcome, AtRestIsStuckAlsoInAPlateThatFliesOff)
{
  for (const double drift : {0., -7.})
  {
    Story story;
    story.fly({0., 0., -100.}, 60. * us, true);
    story.plates[0].velocity.z() = drift;
    story.fly({0., 0., drift + 0.5}, 25. * us, true);
    EXPECT_FALSE(story.watch.decided()) << "half of the 60 us are not over";
    story.fly({0., 0., drift + 0.5}, 30. * us, true);
    ASSERT_TRUE(story.watch.decided());
    const auto verdict = story.watch.verdict("not asked");
    EXPECT_EQ(verdict.outcome, Outcome::stuck);
    EXPECT_EQ(verdict.exit_face, ExitFace::none);
    EXPECT_EQ(verdict.exit_plate, 0);
    if (drift == 0.)
    {
      EXPECT_NEAR(story.watch.max_depth(), 5.5 * mm, 0.1 * mm);
    }
  }
}

TEST(Outcome, InFrontOfATargetThatFliesOffIsPushed)
{
  Story story;
  story.fly({0., 0., -5.}, 200. * us, true);
  story.plates[0].velocity.z() = -8.;
  story.fly({0., 0., -0.01}, 500. * us, false);
  ASSERT_TRUE(story.watch.decided());
  EXPECT_EQ(story.watch.verdict("").outcome, Outcome::pushed);
  EXPECT_EQ(story.watch.verdict("").exit_face, ExitFace::none);
  EXPECT_STREQ(name_of(Outcome::pushed), "pushed");
}

TEST(Outcome, BehindTheUndeformedRearFaceButNotTheRealOneIsNotThrough)
{
  // It drives the plate before it and falls back.
  Story story;
  story.plates[0].velocity.z() = -48.;
  story.fly({0., 0., -50.}, 400. * us, true);
  EXPECT_LT(story.position.z(), -15. * mm);
  story.fly({0., 0., -40.}, 100. * us, false);
  EXPECT_NE(story.watch.verdict("").outcome, Outcome::perforate);
}

TEST(Outcome, OverAnEdgeDescendingIsNoRicochet)
{
  Story story;
  story.position = Vector3(99., 0., 1.) * mm;
  story.fly({100., 0., -1.}, 10. * us, true); // clips the edge
  story.fly({90., 0., -45.}, 100. * us, false);
  ASSERT_TRUE(story.watch.decided());
  const auto verdict = story.watch.verdict("");
  EXPECT_EQ(verdict.outcome, Outcome::edge);
  EXPECT_EQ(verdict.exit_plate, 1);
}

TEST(Outcome, OverAnEdgeRisingIsRicochet)
{
  Story story;
  story.fly({100., 0., -10.}, 50. * us, true);
  story.fly({100., 0., 10.}, 1000. * us, false);
  EXPECT_EQ(story.watch.verdict("").outcome, Outcome::ricochet);
}

TEST(Outcome, PastTheTargetIsUndecided)
{
  Story story;
  story.position = Vector3(95., 0., 20.) * mm;
  story.fly({100., 0., -100.}, 500. * us, false);
  ASSERT_TRUE(story.watch.decided());
  const auto verdict = story.watch.verdict("not asked");
  EXPECT_EQ(verdict.outcome, Outcome::undecided);
  EXPECT_EQ(verdict.exit_plate, 0);
  EXPECT_EQ(verdict.reason, "the projectile has missed the target");
  EXPECT_EQ(story.watch.contact_duration(), 0.);
}

TEST(Outcome, DepthIsNotWhereItFallsAfterwards)
{
  Story story;
  story.position = Vector3(97., 0., 1.) * mm;
  story.fly({100., 0., -100.}, 40. * us, true);
  story.fly({100., 0., -100.}, 400. * us, false);
  EXPECT_NEAR(story.watch.max_depth(), 3.5 * mm, 0.1 * mm);
}

TEST(Outcome, EveryReasonIsAClauseThatCanBeginASentence)
{
  const auto is_clause = [](const std::string &reason)
  { return reason.size() > 5 && std::islower(static_cast<unsigned char>(reason[0])); };
  const auto reasons_of = [&](const Story &story)
  {
    const auto verdict = story.watch.verdict("the final time was reached");
    EXPECT_PRED1(is_clause, verdict.reason) << name_of(verdict.outcome);
    return verdict.outcome;
  };
  std::set<Outcome> seen;
  for (const bool free : {true, false}) // decided, or cut short on the way out
    for (const auto &[plate, velocity] : {std::pair<double, Vector3>{0., {50., 0., 100.}},
                                          {0., {0., 0., -900.}},
                                          {0., {1500., 0., -1.}},
                                          {-50., {0., 0., -1.}},
                                          {0., {0., 0., 0.}}})
    {
      Story story(2);
      story.fly({0., 0., -100.}, 20. * us, true);
      story.plates[0].velocity.z() = plate;
      story.fly(velocity, free ? 400. * us : 45. * us, velocity.norm() == 0.);
      seen.insert(reasons_of(story));
    }
  seen.insert(reasons_of(Story(1)));
  EXPECT_EQ(seen.size(), 6u) << "all outcomes";
}

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
    EXPECT_EQ(verdict.exit_face, ExitFace::rear);
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
    EXPECT_EQ(verdict.exit_face, ExitFace::edge);
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
  EXPECT_EQ(verdict.exit_face, ExitFace::front);
  EXPECT_EQ(verdict.exit_plate, 1);
  EXPECT_GT(run.simulation.projectile().motion().velocity.z(), 0.);
  EXPECT_GT(run.watch.contact_duration(), 0.);
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
