// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/damage_map.h"
#include "ricochet/output/field_writer.h"
#include "ricochet/output/history.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/summary.h"

#include "support/environment.h"
#include "support/scratch_directory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;
namespace fs = std::filesystem;

/// The columns of a history that the picture needs.
const std::vector<History::Column> needed_columns{{"time", "us"},
                                                  {"x", "mm"},
                                                  {"z", "mm"},
                                                  {"speed", "m/s"},
                                                  {"velocity x", "m/s"},
                                                  {"velocity z", "m/s"},
                                                  {"pitch", "deg"},
                                                  {"force normal", "kN"},
                                                  {"force friction", "kN"},
                                                  {"force shank", "kN"},
                                                  {"residual relative", "-"},
                                                  {"energy projectile", "J"},
                                                  {"energy of tomorrow", "J"}};

/// A small run: a plate of 40 x 8 points, a triangle that slides over it. All columns of the
/// history grow evenly.
void write_run(const fs::path &folder, const std::vector<History::Column> &columns = needed_columns,
               const std::string &title = "Test")
{
  FieldWriter fields(MPI_COMM_WORLD, folder, /*vtu=*/false);
  History history(MPI_COMM_WORLD, folder, columns);
  for (int step = 0; step < 4; ++step)
  {
    PointFrame points;
    for (int i = rank(); i < 320; i += n_ranks())
    {
      points.position.emplace_back(1e-3 * (i % 40), 0.5e-3, -1e-3 * (i / 40) - 0.5e-3);
      points.displacement.push_back(Vector3::Zero());
      points.velocity.push_back(Vector3::Zero());
      points.damage.push_back(i / 40 == 0 && i % 40 < 10 * step ? 0.8 : 0.);
      points.state.add({});
      points.body.push_back(1);
      points.in_section.push_back(1);
    }
    const double x = 5e-3 * step;
    SurfaceFrame surface;
    surface.outline = {{x, 0., 0.}, {x + 0.01, 0., 0.}, {x, 0., 0.005}};
    fields.write(1e-5 * step, points, surface);
    history.append(std::vector<double>(columns.size(), 10. * step));
  }
  history.close();
  const std::vector<float> sound(40 * 8, 0.F), broken(40 * 8, 0.9F);
  write_damage_maps(MPI_COMM_WORLD, folder,
                    {{1, 40, 8, 1e-3, {0., 0.}, true, broken, sound, sound}});
  write_summary(MPI_COMM_WORLD, folder,
                {{"outcome", "ricochet"},
                 {"title", title},
                 {"max_depth_mm", nullptr}, // of a perforation
                 {"exit_speed_m_s", 470.},
                 {"exit_angle_deg", 12.},
                 {"plate_1_broken_share", 0.1},
                 {"plate_1_front_damaged_mm2", 640.},
                 {"plate_1_rear_damaged_mm2", 0.},
                 {"positions", {{{"time_us", 10.}}, {{"time_us", 20.}}}}});
}

bool python_has_modules()
{
  static const bool found =
      std::system("/usr/bin/python3 -c 'import matplotlib, h5py' > /dev/null 2>&1") == 0;
  return found;
}

bool is_png(const fs::path &path)
{
  return contains(read_text(path).substr(0, 8), "PNG");
}

TEST(Pictures, AreDrawnFromTheResultsAlone)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  // A name that a shell would take apart.
  const fs::path folder = scratch.path() / "run; touch $(echo bad) 'x'";
  if (rank() == 0)
    fs::create_directory(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  write_run(folder);
  ::testing::internal::CaptureStdout();
  EXPECT_TRUE(draw_pictures(MPI_COMM_WORLD, folder, /*quiet=*/false));
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(contains(text, "section.png") && contains(text, "history.png"), rank() == 0) << text;
  EXPECT_TRUE(is_png(folder / "section.png"));
  EXPECT_TRUE(is_png(folder / "damage.png"));
  EXPECT_TRUE(is_png(folder / "history.png"));
}

TEST(Pictures, FindTheirColumnsByNameAndNameTheOneThatIsMissing)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  auto columns = needed_columns;
  std::reverse(columns.begin(), columns.end());
  write_run(scratch.path(), columns);
  EXPECT_TRUE(draw_pictures(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));

  columns.erase(columns.begin() + 3, columns.begin() + 4); // "force shank"
  write_run(scratch.path(), columns);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_pictures(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "history.csv has no column 'force shank'; it has energy of tomorrow, "),
            rank() == 0)
      << text;
}

TEST(Pictures, OfAStudyCompareItsCases)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  for (const char *name : {"one", "two"})
  {
    if (rank() == 0)
      fs::create_directory(scratch.path() / name);
    MPI_Barrier(MPI_COMM_WORLD);
    write_run(scratch.path() / name);
  }
  if (rank() == 0) // the third case has failed
    std::ofstream(scratch.path() / "study.csv")
        << "case,outcome,status\none,ricochet,ok\ntwo,ricochet,ok\nthree,,failed\n";
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(draw_study_picture(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  EXPECT_TRUE(is_png(scratch.path() / "comparison.png"));
}

TEST(Pictures, TakeAnyTitleAsItIs)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  const std::string title = "cost $5, \\frac{a$";
  if (rank() == 0)
    fs::create_directory(scratch.path() / "one");
  MPI_Barrier(MPI_COMM_WORLD);
  write_run(scratch.path() / "one", needed_columns, title);
  if (rank() == 0)
  {
    std::ofstream(scratch.path() / "study.csv") << "case,status\none,ok\n";
    std::ofstream(scratch.path() / "study.json")
        << nlohmann::json{{"title", title},
                          {"axes", nlohmann::json::array()},
                          {"cases",
                           {{{"name", "one"},
                             {"label", title},
                             {"axes", nlohmann::json::array()},
                             {"status", "ok"}}}}};
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(draw_pictures(MPI_COMM_WORLD, scratch.path() / "one", /*quiet=*/true));
  EXPECT_TRUE(draw_study_picture(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
}

TEST(Pictures, OfManyCasesHavePages)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  std::string table = "case,status\n";
  for (int i = 0; i < 9; ++i)
  {
    const auto name = "case_" + std::to_string(i);
    if (rank() == 0)
      fs::create_directory(scratch.path() / name);
    MPI_Barrier(MPI_COMM_WORLD);
    write_run(scratch.path() / name);
    table += name + ",ok\n";
  }
  if (rank() == 0)
    std::ofstream(scratch.path() / "study.csv") << table;
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(draw_study_picture(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  EXPECT_TRUE(is_png(scratch.path() / "comparison_2.png"));
  EXPECT_FALSE(fs::exists(scratch.path() / "comparison_3.png"));
}

TEST(Pictures, OfAStudyWithoutResultsSayWhy)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  if (rank() == 0)
    std::ofstream(scratch.path() / "study.csv") << "case,status\none,failed\n";
  MPI_Barrier(MPI_COMM_WORLD);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_study_picture(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "no case of"), rank() == 0) << text;
}

const std::string comparison_header =
    "case,scene,group,title,reference,runs,outcomes,same_outcome,compared_at_us,reference_path_mm,"
    "path_error_percent,path_error_low_percent,path_error_high_percent,reference_scatter_percent,"
    "exit_speed_m_s,exit_speed_low_m_s,exit_speed_high_m_s,exit_speed_error_percent,core_seconds,"
    "core_seconds_low,core_seconds_high,cost_ratio\n";

TEST(Pictures, OfAComparisonWithAReference)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  for (const std::string &group :
       {std::string(), std::string("speed_800_m_s")}) // one panel with time beside it, two
  {
    const ScratchDirectory scratch;
    if (rank() == 0)
    {
      std::ofstream table(scratch.path() / "comparison.csv");
      std::ofstream paths(scratch.path() / "comparison_paths.csv");
      table << comparison_header;
      paths << "case,stated_us,reference_path_mm,path_error_percent,path_error_low_percent,"
               "path_error_high_percent,reference_scatter_percent\n";
      for (const std::string &value : {std::string(), group})
      {
        table << "full" << value << ",full," << value << ",\"A, full\",full" << value
              << ",2,2 ricochet,1.0,260.0,100.0,0.0,0.5,0.7,0.7,300,290,310,0.0,5,4.9,5.1,1.0\n"
              << "zone" << value << ",zone," << value << ",\"A, zone\",full" << value
              << ",2,2 ricochet,1.0,260.0,100.0,1.2,0.5,1.7,0.7,300,290,310,0.0,2,1.9,2.1,0.4\n"
              << "none" << value << ",none," << value << ",-,full" << value
              << ",0,-,-,-,-,-,-,-,-,-,-,-,-,-,-,-,-\n"; // all runs have failed
        paths << "full" << value << ",260.0,100.0,0.0,0.5,0.7,0.7\n"
              << "zone" << value << ",260.0,100.0,1.2,0.5,1.7,0.7\n";
        if (group.empty())
          break;
      }
    }
    MPI_Barrier(MPI_COMM_WORLD);
    EXPECT_TRUE(draw_accuracy_chart(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
    EXPECT_TRUE(is_png(scratch.path() / "accuracy.png"));
  }
}

TEST(Pictures, OfAComparisonWithoutRunsSayWhy)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  if (rank() == 0)
  {
    std::ofstream(scratch.path() / "comparison.csv") << comparison_header;
    std::ofstream(scratch.path() / "comparison_paths.csv") << "case\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_accuracy_chart(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "no run could be compared"), rank() == 0) << text;
}

TEST(Pictures, WithoutResultsSayWhy)
{
  if (!python_has_modules())
    GTEST_SKIP() << "python3 has no matplotlib or h5py";
  const ScratchDirectory scratch;
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_pictures(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "neither section.h5 nor history.csv"), rank() == 0) << text;
}

TEST(Pictures, WithoutScriptNameTheVariable)
{
  const ScratchDirectory scratch;
  const Variable variable("RICOCHET_SCRIPT_DIR", scratch.path() / "nowhere");
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_pictures(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "RICOCHET_SCRIPT_DIR"), rank() == 0) << text;
}

TEST(Pictures, WithoutPythonModulesNameThePackages)
{
  const ScratchDirectory scratch;
  // Stands for a python without matplotlib: whichever python runs finds this one first.
  if (rank() == 0)
    std::ofstream(scratch.path() / "matplotlib.py")
        << "raise ImportError('No module named matplotlib')\n";
  MPI_Barrier(MPI_COMM_WORLD);
  const Variable variable("PYTHONPATH", scratch.path());
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_pictures(MPI_COMM_WORLD, scratch.path(), /*quiet=*/true));
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(text, "apt install python3-matplotlib python3-h5py"), rank() == 0) << text;
}
} // namespace
} // namespace ricochet
