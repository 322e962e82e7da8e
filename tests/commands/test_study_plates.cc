// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/study.h"
#include "commands/study_plates.h"

#include "support/scene_text.h"
#include "support/scratch_directory.h"
#include "support/two_plates_text.h"

#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;
using Json = nlohmann::ordered_json;

/// A study of the two plates, 40 x 20 x 6 mm, 1 mm apart points, over one axis.
std::string write_study(const std::filesystem::path &folder, const std::string &axis,
                        const std::string &more = "")
{
  if (rank() == 0)
  {
    std::ofstream(folder / "base.prm") << two_plates_text;
    std::ofstream(folder / "study.prm")
        << "subsection Study\n  set Scenes = base.prm\n  set Axis 1 = " << axis << "\n"
        << "  set Columns = outcome\n  set Settings = Time/Final time: 1 us\n"
        << "  set Pictures = false\n  set Report = false\n  set Output directory = "
        << (folder / "results").string() << "\n"
        << more << "end\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return (folder / "study.prm").string();
}

TEST(StudyPlates, ThatTheGridMakesDifferAreNamed)
{
  const ScratchDirectory scratch;
  const auto study =
      read_study(write_study(scratch.path(), "Plate 2/Grid spacing: 1 mm | 0.75 mm | 0.5 mm"));
  const StudyPlates plates(study);
  // 53 x 2 * 13 x 8 points of 0.75 mm; the thickness stays.
  EXPECT_EQ(plates.columns(), (std::vector<std::string>{"plate_2_length_mm", "plate_2_width_mm"}));
  EXPECT_EQ(Json(plates.row(0)), Json({40., 20.}));
  EXPECT_NEAR(plates.row(1).at(0), 39.75, 1e-12);
  EXPECT_NEAR(plates.row(1).at(1), 19.5, 1e-12);
  EXPECT_EQ(Json(plates.row(2)), Json({40., 20.}));
  const auto text = plates.warning();
  for (const char *part :
       {"plate 2: 40 x 20 x 6 mm for 40 x 20 x 6 mm, first in base__grid_spacing_1_mm",
        "plate 2: 39.75 x 19.5 x 6 mm for 40 x 20 x 6 mm, first in base__grid_spacing_0.75_mm"})
    EXPECT_TRUE(contains(text, part)) << part << " in\n" << text;
  EXPECT_FALSE(contains(text, "plate 1")) << text;
}

TEST(StudyPlates, ThatAreAskedForDifferentlyMayDiffer)
{
  const ScratchDirectory scratch;
  const auto study = read_study(
      write_study(scratch.path(), "Plate 1/Size: 40 mm, 20 mm, 6 mm | 60 mm, 20 mm, 6 mm"));
  const StudyPlates plates(study);
  EXPECT_TRUE(plates.columns().empty());
  EXPECT_TRUE(plates.row(1).empty());
  EXPECT_EQ(plates.warning(), "");
}

TEST(StudyPlates, ThatTheGridChangesTooMuchAreFoundBeforeTheFirstRun)
{
  const ScratchDirectory scratch;
  // 6 mm are 4.6 spacings.
  const auto path = write_study(scratch.path(), "Plate 1/Grid spacing: 1 mm | 1.3 mm");
  expect_error([&] { run_study(MPI_COMM_WORLD, path, {}); },
               {"base__grid_spacing_1.3_mm", "thickness", "6 mm", "6.5 mm", "5 %"});
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "results"));
}

TEST(StudyPlates, StandInTheTableOfTheStudyWithAWarning)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "Plate 1/Grid spacing: 1 mm | 0.75 mm");
  StudyOptions options;
  options.quiet = true;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(run_study(MPI_COMM_WORLD, path, options).n_failed, 0);
  ::testing::internal::GetCapturedStdout();
  const std::string warning = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(warning, "warning: cases that ask for the same plates"), rank() == 0);
  if (rank() != 0)
    return;
  const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "case,grid_spacing_mm,outcome,plate_1_length_mm,plate_1_width_mm,status");
  EXPECT_TRUE(contains(lines[1], ",40.0,20.0,ok")) << lines[1];
  EXPECT_TRUE(contains(lines[2], ",39.75,19.5,ok")) << lines[2];
}
} // namespace
} // namespace ricochet
