// SPDX-License-Identifier: LGPL-2.1-or-later
// Ordinary impacts with a right answer in closed form or by invariance, from a parameter file to
// the results: tests/cases/*.prm.
#include "commands/run.h"

#include "support/history_file.h"
#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet
{
namespace
{
using namespace tests;
using Settings = std::vector<std::string>;

struct Result
{
  nlohmann::ordered_json summary;
  HistoryFile history;
};

/// Of the case, with further settings as on the command line.
Result run_case(const std::string &name, const Settings &settings = {})
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  auto all          = settings;
  all.push_back("Output/Directory=" + folder.string());
  RunOptions options;
  options.quiet = true;
  auto summary  = run_scene(
       MPI_COMM_SELF,
       ParameterFile(RICOCHET_SOURCE_DIR "/tests/cases/" + name, parse_overrides(all)), options);
  return {std::move(summary), HistoryFile(folder / "history.csv")};
}

TEST(OrdinaryScenes, BallComesBackFromABlockAsTwoMassesDo)
{
  // Momentum and energy of 2.1 kg at 3 m/s and a free block of 240 mm x 240 mm x 80 mm: what rings
  // in the block afterwards is lost to the ball, below 1 %.
  const double block = 0.24 * 0.24 * 0.08 * 1190., ball = 2.1;
  const double exact = 3. * (block - ball) / (block + ball);
  for (const char *free_time : {"1 us", "50 us"})
  {
    const auto s =
        run_case("ball_on_block.prm", {std::string("Time/Free time=") + free_time}).summary;
    EXPECT_EQ(s["outcome"], "ricochet") << s["reason"];
    EXPECT_NEAR(s["exit_speed_m_s"].get<double>(), exact, 0.01 * exact);
  }
}

TEST(OrdinaryScenes, NothingHoldsADiskThatHasHitABar)
{
  const auto s = run_case("bar_hit_by_a_disk.prm").summary;
  EXPECT_NE(s["outcome"], "stuck") << s["reason"];
  EXPECT_NE(s["outcome"], "perforate") << s["reason"];
}

TEST(OrdinaryScenes, FrictionTakesEnergyInEveryStep)
{
  for (const auto &[name, mu] :
       {std::pair<const char *, const char *>{"sphere_friction.prm", "0.3"},
        {"ogive_small.prm", "1"},
        {"ogive_small.prm", "20"}})
  {
    const auto [s, history] = run_case(name, {"Contact/Friction law=constant",
                                              std::string("Contact/Static friction=") + mu,
                                              "Output/History interval=1 ns"}); // every step
    const auto heat         = history.column("work friction");
    ASSERT_GT(heat.size(), 100u);
    EXPECT_GT(heat.back(), 0.1);
    for (std::size_t i = 1; i < heat.size(); ++i)
      EXPECT_GE(heat[i], heat[i - 1]) << name << ", mu = " << mu << ", row " << i;
    EXPECT_LT(std::abs(s["energy_residual"].get<double>()), 0.005) << name << ", mu = " << mu;
  }
}

TEST(OrdinaryScenes, ClearanceDoesNotMoveTheEntryPoint)
{
  // A grazing ogive, 10 deg, on a plate that does not break.
  const auto exit = [](const char *clearance)
  {
    return run_case("ogive_small.prm",
                    {"Impact/Entry point=50 mm, 0 mm", "Impact/Incidence angle=10 deg",
                     "Material M/Critical stretch=10", "Time/Final time=250 us",
                     std::string("Impact/Clearance=") + clearance})
        .summary["exit_speed_m_s"]
        .get<double>();
  };
  const double near = exit("0.05 mm");
  EXPECT_GT(near, 600.);
  for (const char *clearance : {"1 mm", "5 mm"})
    EXPECT_NEAR(exit(clearance), near, 1e-3 * near) << clearance;
}

TEST(OrdinaryScenes, RodOnItsSideHasCoulombsFrictionAlone)
{
  const auto [s, history] = run_case("rod_on_its_side.prm");
  const auto x = history.column("velocity x"), z = history.column("velocity z");
  ASSERT_EQ(s["outcome"], "ricochet") << s["reason"];
  // The normals of the points at its edges are tilted by some degrees.
  EXPECT_NEAR((x.front() - x.back()) / (z.back() - z.front()), 0.1, 0.005);
}

TEST(OrdinaryScenes, VelocitiesInTheHistoryAreThoseOfTheirTime)
{
  // Change of position against the velocities of the rows by the trapezoidal rule: of second order
  // in the step, while velocities half a step late would leave v dt/2 of a change of v.
  const auto defect = [](const char *safety)
  {
    const auto history =
        run_case("sphere_friction.prm", {std::string("Time/Safety factor=") + safety,
                                         "Output/History interval=1 ns", "Time/Final time=60 us"})
            .history;
    const auto t = history.column("time"), z = history.column("z"),
               v = history.column("velocity z");
    double path  = 0.;
    for (std::size_t i = 1; i < t.size(); ++i)
      path += 0.5e-3 * (v[i] + v[i - 1]) * (t[i] - t[i - 1]); // mm
    return std::abs(z.back() - z.front() - path) / std::abs(v.back() - v.front());
  };
  EXPECT_NEAR(defect("0.7") / defect("0.35"), 4., 1.);
}

TEST(OrdinaryScenes, TumblingBodyTurnsOnBeyondAQuarterTurn)
{
  // A rod that hits with its end far from its centre of mass turns over; no step is a jump.
  const auto pitch =
      run_case("rod_on_its_side.prm",
               {"Impact/Incidence angle=60 deg", "Impact/Attack angle=30 deg",
                "Impact/Speed=400 m/s", "Material M/Critical stretch=10",
                "Plate 1/Grid spacing=4 mm", "Time/Final time=3000 us", "Time/Stop early=false"})
          .history.column("pitch");
  for (std::size_t i = 1; i < pitch.size(); ++i)
    EXPECT_LT(std::abs(pitch[i] - pitch[i - 1]), 20.);
  EXPECT_GT(std::abs(pitch.back() - pitch.front()), 120.);
}
} // namespace
} // namespace ricochet
