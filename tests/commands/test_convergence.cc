// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/convergence.h"

#include "ricochet/output/table.h"
#include "ricochet/scene/text_tools.h"
#include "support/scene_text.h"
#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

/// A study over these grids whose runs fly along x at 1 mm/us + their grid spacing in mm/us until
/// 10 us, and leave at 100 m/s + 7 h^2.
class ConvergenceOf : public testing::Test
{
protected:
  Convergence converged(const std::string &entries)
  {
    folder.write("one.prm", scene_text);
    const auto study =
        read_study(folder.write("study.prm", "subsection Study\nset Scenes = one.prm\n"
                                             "set Kind = convergence\n" +
                                                 entries + "end\n"));
    std::vector<Json> summaries;
    for (const auto &one : study.cases)
    {
      const double h      = *one.axis_values[0].number;
      const std::string x = number_text(10. * (1. + h));
      summaries.push_back({{"failed", false},
                           {"interrupted", false},
                           {"outcome", "ricochet"},
                           {"exit_speed_m_s", 100. + 7. * h * h},
                           {"max_depth_mm", nullptr},
                           {"core_seconds", 1.}});
      path = folder.write("results/" + one.name + "/history.csv",
                          "time [us],x [mm],y [mm],z [mm]\n0,0,0,0\n10," + x + ",0,0\n");
    }
    return converge(study, summaries, std::filesystem::path(path).parent_path().parent_path());
  }

  Folder folder;
  std::string path;
};

TEST_F(ConvergenceOf, ErrorsAreAgainstTheFinestAndOrdersAreFound)
{
  const auto found = converged("set Axis 1 = Plate 1/Grid spacing: 1 mm | 2 mm | 0.5 mm\n");
  const auto rows  = split(found.csv, '\n');
  ASSERT_GE(rows.size(), 4u);
  EXPECT_EQ(rows[0].rfind("group,grid_spacing_mm,points_per_calibre,runs,compared_at_us,path_error_"
                          "percent,path_mm,path_mm_standard_error,exit_speed_m_s,",
                          0),
            0u);
  // From the coarsest: a calibre of 6 mm, paths of 30, 20 and 15 mm.
  const auto coarsest = split(rows[1], ','), finest = split(rows[3], ',');
  EXPECT_EQ(coarsest[1], "2.0");
  EXPECT_NEAR(std::stod(coarsest[2]), 3., 1e-12);
  EXPECT_EQ(coarsest[4], "10.0");
  EXPECT_NEAR(std::stod(coarsest[5]), 100., 1e-9);
  EXPECT_NEAR(std::stod(coarsest[10]), 100. * (128. / 101.75 - 1.), 1e-9); // of the exit speed
  EXPECT_EQ(finest[1], "0.5");
  EXPECT_EQ(finest.back(), "1");

  const auto orders = split(found.orders, '\n');
  EXPECT_EQ(orders.at(1).rfind("-,path_mm,", 0), 0u);
  EXPECT_NEAR(std::stod(split(orders[1], ',')[2]), 1., 1e-9);
  EXPECT_NEAR(std::stod(split(orders.at(2), ',')[2]), 2., 1e-9);
  EXPECT_NE(orders.at(3).find("max_depth_mm,-,-,-,none: not every grid has a value"),
            std::string::npos)
      << orders[3];
}

TEST_F(ConvergenceOf, RepeatedRunsAreMeans)
{
  const auto found = converged("set Axis 1 = Plate 1/Grid spacing: 2 mm | 1 mm\n"
                               "set Axis 2 = Time/Safety factor: 0.6 | 0.7\n"
                               "set Ensemble = Axis 2\nset Reference = 2 mm\n");
  const auto rows  = split(found.csv, '\n');
  const auto other = split(rows.at(2), ',');
  EXPECT_EQ(other[3], "2");   // runs
  EXPECT_EQ(other[7], "0.0"); // standard error of equal runs
  EXPECT_NEAR(std::stod(other[5]), 100. / 3., 1e-9);
  EXPECT_EQ(split(rows[1], ',').back(), "1");
}
} // namespace
} // namespace ricochet::tests
