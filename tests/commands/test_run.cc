// SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to the summary: what a run says about stated times, plates and friction.
#include "commands/run.h"

#include "ricochet/base/version.h"

#include "support/scene_text.h"
#include "support/scratch_directory.h"
#include "support/two_plates_text.h"
#include "support/verification.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace ricochet
{
namespace
{
using namespace tests;

TEST(Run, SummaryTellsPositionsAtStatedTimesAndDamagePerPlate)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  RunOptions options;
  options.quiet    = true;
  const auto s     = run_scene(MPI_COMM_WORLD, two_plates_file(folder.string()), options);
  const double dt  = s["time_step_us"];
  const auto &list = s["positions"];
  ASSERT_EQ(list.size(), 3u); // the fourth time lies behind the end
  const double stated[] = {0., 12.3, 20.};
  for (int i = 0; i < 3; ++i)
  {
    const auto &position = list[i];
    const double time    = position["time_us"];
    EXPECT_DOUBLE_EQ(position["stated_us"], stated[i]);
    EXPECT_GE(time, stated[i]); // the first step that is not before
    EXPECT_LT(time, stated[i] + dt);
    if (rank() == 0)
    {
      const std::string frame = "frame_000" + std::to_string(i);
      EXPECT_NEAR(read_attribute(folder / "section.h5", frame, "time_s"), 1e-6 * time, 1e-18);
    }
  }
  EXPECT_EQ(list[0]["path_mm"], 0.);
  EXPECT_DOUBLE_EQ(list[0]["speed_m_s"], 300.);
  EXPECT_NEAR(list[0]["angle_deg"], -30., 1e-9);
  // It only loses speed on the way.
  const double path = list[2]["path_mm"];
  EXPECT_GT(path, 0.5 * 0.3 * 20.);
  EXPECT_LT(path, 0.3 * 20.4);

  const double first = s["plate_1_broken_share"], second = s["plate_2_broken_share"];
  EXPECT_GT(first, second);
  EXPECT_GT(first, 0.005);
  EXPECT_GE(second, 0.);
  EXPECT_GT(s["plate_1_front_damaged_mm2"], 10.);
  EXPECT_GT(s["contact_duration_us"], 5.);
  if (rank() == 0)
  {
    EXPECT_EQ(read_dataset(folder / "damage.h5", "plate_2_rear").shape,
              (std::vector<hsize_t>{40, 10}));
    // Debris rubs.
    const auto lines = split(read_text(folder / "history.csv"), '\n');
    const auto names = split(lines.front(), ','), last = split(lines.back(), ',');
    for (std::size_t i = 0; i < names.size(); ++i)
      if (contains(names[i], "work debris friction"))
      {
        EXPECT_GT(std::stod(last.at(i)), 0.);
        return;
      }
    FAIL() << "no column of the work of debris friction";
  }
}

/// A ball, and one that comes 14 us later.
ParameterFile two_balls_file(const std::string &folder)
{
  std::string text = two_plates_text;
  for (const char *kind : {"Projectile", "Impact"})
  {
    const auto begin = two_plates_text.find("subsection " + std::string(kind));
    const auto end   = two_plates_text.find("end\n", begin) + 4;
    std::string copy = two_plates_text.substr(begin, end - begin);
    copy.insert(copy.find(kind) + std::string(kind).size(), " 2");
    text += copy;
  }
  return ParameterFile::from_text(
      text, "two_balls.prm",
      parse_overrides({"Output/Directory=" + folder, "Impact/Incidence angle=90 deg",
                       "Impact/Speed=600 m/s", "Impact 2/Incidence angle=90 deg",
                       "Impact 2/Speed=550 m/s", "Impact 2/Entry point=30 mm, 0 mm",
                       "Impact 2/Clearance=8 mm", "Time/Final time=300 us"}));
}

TEST(Run, WithTwoProjectilesEndsWhenBothAreDecided)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  RunOptions options;
  options.quiet    = true;
  const auto s     = run_scene(MPI_COMM_WORLD, two_balls_file(folder.string()), options);
  const auto &both = s["projectiles"];
  ASSERT_EQ(both.size(), 2u);
  EXPECT_LT(s["time_us"], 250.);
  EXPECT_EQ(both[0]["outcome"], "perforate") << both[0];
  EXPECT_NE(both[1]["outcome"], "undecided") << both[1];
  EXPECT_TRUE(contains(both[1]["reason"], "touched nothing for 5 us")) << both[1];
  // The first one's fields stand at the top as well.
  for (const auto &[name, value] : both[0].items())
    EXPECT_EQ(s[name], value) << name;
  EXPECT_GT(both[0]["exit_speed_m_s"], both[1]["exit_speed_m_s"]);
  ASSERT_EQ(both[1]["positions"].size(), s["positions"].size());
  EXPECT_EQ(both[1]["positions"][0]["x_mm"], 30.);
  const std::string text = describe_run(s);
  EXPECT_TRUE(contains(text, "projectile 2 ")) << text;
  if (rank() == 0)
  {
    const auto names = split(split(read_text(folder / "history.csv"), '\n').front(), ',');
    EXPECT_EQ(names.back(), "force z 2 [kN]");
  }
}

TEST(Run, TellsAtTheStartAndInTheSummaryHowLargePlatesAreComputed)
{
  const ScratchDirectory scratch;
  const auto file = two_plates_file((scratch.path() / "results").string(),
                                    {"Plate 2/Grid spacing=0.75 mm", "Time/Final time=1 us"});
  ::testing::internal::CaptureStdout();
  const auto s           = run_scene(MPI_COMM_WORLD, file, {});
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(contains(text, "plate 2 is computed as 39.75 x 19.5 x 6 mm instead of 40 x 20 x 6 mm"),
            rank() == 0)
      << text;
  EXPECT_FALSE(contains(text, "plate 1")) << text;
  const std::map<std::string, double> expected{
      {"plate_1_length_mm", 40.},        {"plate_1_width_mm", 20.},
      {"plate_1_thickness_mm", 6.},      {"plate_2_length_mm", 39.75},
      {"plate_2_width_mm", 19.5},        {"plate_2_thickness_mm", 6.},
      {"plate_2_asked_length_mm", 40.},  {"plate_2_asked_width_mm", 20.},
      {"plate_2_asked_thickness_mm", 6.}};
  for (const auto &[name, value] : expected)
    EXPECT_NEAR(s[name].get<double>(), value, 1e-12 * value) << name;
}

/// With all that a frame looks at: bonds and elements that relax, points that follow elements.
ParameterFile relaxing_file(const std::string &folder, const std::vector<std::string> &more)
{
  std::vector<std::string> overrides{"Material PMMA/Relaxation shares=0.3, 0.2",
                                     "Material PMMA/Relaxation times=5 us, 40 us",
                                     "Coupling/Zone=boxes",
                                     "Coupling/Adaptive=true",
                                     "Plate 1/Zone box=4 mm, 24 mm, -6 mm, 6 mm",
                                     "Plate 2/Zone box=4 mm, 24 mm, -6 mm, 6 mm",
                                     "Output/History interval=0.5 us",
                                     "Time/Final time=12 us"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return two_plates_file(folder, overrides);
}

TEST(Run, FramesLeaveNoTraceInTheHistory)
{
  const ScratchDirectory scratch;
  RunOptions options;
  options.quiet      = true;
  const auto history = [&](const std::string &name, const std::vector<std::string> &more)
  {
    const auto folder = scratch.path() / name;
    run_scene(MPI_COMM_WORLD, relaxing_file(folder.string(), more), options);
    return rank() == 0 ? read_text(folder / "history.csv") : std::string();
  };
  const auto without = history("without", {"Output/Picture times=100 us"}),
             with = history("with", {"Output/Frame interval=0.3 us", "Output/ParaView files=true"});
  EXPECT_EQ(with, without);
  verify_at_most("V28", "output: whether the history differs if frames are written",
                 with != without, 0.);
  EXPECT_EQ(std::filesystem::exists(scratch.path() / "with/vtu/points_0020.pvtu"), true);
}

TEST(Run, SectionIsTheSameWithoutParaViewFiles)
{
  const ScratchDirectory scratch;
  RunOptions options;
  options.quiet = true;
  for (const std::string vtu : {"true", "false"})
    run_scene(MPI_COMM_WORLD,
              relaxing_file((scratch.path() / vtu).string(),
                            {"Output/Frame interval=4 us", "Output/ParaView files=" + vtu}),
              options);
  if (rank() != 0)
    return;
  const auto with      = scratch.path() / "true/section.h5",
             without   = scratch.path() / "false/section.h5";
  std::size_t n_values = 0;
  for (const std::string frame : {"frame_0000/", "frame_0001/", "frame_0002/", "frame_0003/"})
    for (const char *field :
         {"position", "damage", "body", "pressure", "von_mises", "energy_density", "outline"})
    {
      const auto one   = read_dataset(with, frame + field),
                 other = read_dataset(without, frame + field);
      EXPECT_EQ(one.shape, other.shape) << frame << field;
      EXPECT_EQ(one.values, other.values) << frame << field;
      n_values += one.values.size();
    }
  EXPECT_GT(n_values, 4u * 8u * 2u * 40u * 6u); // all of both plates' layers
}

TEST(Run, FinishedOnesAreNotOverwrittenUnasked)
{
  const ScratchDirectory scratch;
  const auto folder = (scratch.path() / "results").string();
  const auto file   = two_plates_file(folder, {"Time/Final time=1 us"});
  RunOptions options;
  options.quiet = true;
  run_scene(MPI_COMM_WORLD, file, options);
  EXPECT_TRUE(contains(message_of([&] { run_scene(MPI_COMM_WORLD, file, options); }), "--force"));
  options.force = true;
  EXPECT_EQ(run_scene(MPI_COMM_WORLD, file, options)["failed"], false);
}

TEST(Run, OneThatBreaksDownHasAReportToo)
{
  const ScratchDirectory scratch;
  const auto folder = (scratch.path() / "results").string();
  RunOptions options;
  options.quiet = true;
  // Contact so stiff that a single step gives the points more energy than the projectile has.
  const auto file =
      two_plates_file(folder, {"Contact/Stiffness factor=1000", "Time/Safety factor=1",
                               "Impact/Speed=5000 m/s", "Output/Report=true"});
  expect_error<RunError>([&] { run_scene(MPI_COMM_WORLD, file, options); }, {"energy runs away"});
  if (rank() == 0)
  {
    EXPECT_TRUE(contains(read_text(scratch.path() / "results" / "report.html"), "runs away"));
  }
}

TEST(Run, EveryResultFileNamesTheVersion)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  RunOptions options;
  options.quiet = true;
  const auto file =
      two_plates_file(folder.string(), {"Output/ParaView files=true", "Time/Final time=2 us"});
  const auto s = run_scene(MPI_COMM_WORLD, file, options);
  EXPECT_EQ(s["version"], version());
  if (rank() != 0)
    return;
  // A table has no place for it and parameters are not results; summary.json lies next to both.
  std::map<std::string, int> files;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
  {
    const std::string kind = entry.path().extension();
    if (!entry.is_regular_file() || kind.empty() || kind == ".csv" || kind == ".prm")
      continue;
    EXPECT_TRUE(contains(read_text(entry.path()), version())) << entry.path();
    ++files[kind];
  }
  for (const char *kind : {".json", ".h5", ".vtu", ".pvtu", ".pvd"})
    EXPECT_GT(files[kind], 0) << kind;
}

TEST(Run, DescriptionHasTheNumbersOfItsSummary)
{
  const nlohmann::ordered_json summary{
      {"outcome", "ricochet"},
      {"reason", "it has left"},
      {"exit_speed_m_s", 287.4},
      {"exit_angle_deg", 12.34},
      {"pitch_deg", -3.21},
      {"time_us", 401.6},
      {"max_depth_mm", 4.56},
      {"path_mm", 123.4},
      {"energy_residual", 0.00123},
      {"momentum_drift", nullptr}, // not a number
      {"angular_momentum_drift", 2.2e-13},
      {"points", 1234567},
      {"steps", 3000},
      {"core_seconds", 12.34},
      {"phases", {{"rest", 0.1}, {"debris", 2.4}, {"points", 9.84}}},
      {"bond_rate_per_core", 4.19e8},
      {"directory", "results/x"}};
  EXPECT_EQ(
      describe_run(summary),
      "\noutcome     ricochet: it has left\n"
      "exit        287 m/s at 12.3 deg to the plate, pitch -3.2 deg, after 402 us; deepest 4.56 "
      "mm, path 123 mm\n"
      "balance     energy residual 0.12 % of the impact energy, momentum drift nan, angular "
      "momentum drift 2e-13\n"
      "cost        1234567 points, 3000 steps, 12.3 core-seconds, 419 M directed bonds/s per "
      "core\n"
      "time        points 80 %, debris 19 %\n"
      "results     results/x");
}
} // namespace
} // namespace ricochet
