// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/scene/scene_reader.h"
#include "scene_text.h"

namespace ricochet::tests
{
namespace
{
std::vector<std::string> case_names(const StudyParameters &study)
{
  std::vector<std::string> names;
  for (const auto &one : study.cases)
    names.push_back(one.name);
  return names;
}

/// A folder with two scenes, and studies beside them.
class StudyFile : public testing::Test
{
protected:
  StudyFile()
  {
    folder.write("scenes/one.prm", scene_text);
    folder.write("scenes/two.prm", scene_text);
  }

  StudyParameters study(const std::string &entries) const
  {
    return read_study(folder.write("study.prm", "subsection Study\n" + entries + "end\n"));
  }

  void expect_study_error(const std::string &entries, const std::vector<std::string> &parts) const
  {
    expect_error([&] { study(entries); }, parts);
  }

  Folder folder;
};

using Names = std::vector<std::string>;

TEST_F(StudyFile, CasesAreScenesTimesAxes)
{
  const auto read = study("set Scenes = scenes/one.prm, scenes/two.prm\n"
                          "set Axis 1 = Plate 1/Grid spacing: 2.5 mm | 2.0 mm\n"
                          "set Axis 2 = Impact/Speed: 0.5 mm/us | 800 m/s\n");
  EXPECT_EQ(
      case_names(read),
      (Names{"one__grid_spacing_2.5_mm__speed_0.5_mm_us", "one__grid_spacing_2.5_mm__speed_800_m_s",
             "one__grid_spacing_2.0_mm__speed_0.5_mm_us", "one__grid_spacing_2.0_mm__speed_800_m_s",
             "two__grid_spacing_2.5_mm__speed_0.5_mm_us", "two__grid_spacing_2.5_mm__speed_800_m_s",
             "two__grid_spacing_2.0_mm__speed_0.5_mm_us",
             "two__grid_spacing_2.0_mm__speed_800_m_s"}));
  const auto &last  = read.cases.back();
  const Scene scene = read_scene(ParameterFile(last.scene_file, last.overrides));
  EXPECT_DOUBLE_EQ(scene.plates[0].spacing, 2e-3);
  EXPECT_DOUBLE_EQ(scene.impact.speed, 800.);
  EXPECT_EQ(scene.output.directory, "output/study/" + last.name);
}

TEST_F(StudyFile, OneSceneWithoutAxesIsOneCase)
{
  const auto read = study("set Scenes = scenes/one.prm\nset Title = A title\n"
                          "set Output directory = there\nset Columns = outcome, exit_speed\n");
  EXPECT_EQ(case_names(read), (Names{"one"}));
  EXPECT_EQ(read.title, "A title");
  EXPECT_EQ(read.output_directory, "there");
  EXPECT_EQ(read.columns, (Names{"outcome", "exit_speed"}));
}

TEST_F(StudyFile, AxesMayBeVariedOneAtATime)
{
  const auto read = study("set Scenes = scenes/one.prm, scenes/two.prm\n"
                          "set Combine = one at a time\n"
                          "set Axis 1 = Impact/Speed: 700 m/s | 800 m/s\n"
                          "set Axis 2 = Contact/Static friction: 0.3\n");
  EXPECT_TRUE(read.one_at_a_time);
  EXPECT_EQ(case_names(read),
            (Names{"one", "one__speed_700_m_s", "one__speed_800_m_s", "one__static_friction_0.3",
                   "two", "two__speed_700_m_s", "two__speed_800_m_s", "two__static_friction_0.3"}));
  const Scene scene = read_scene(ParameterFile(read.cases[3].scene_file, read.cases[3].overrides));
  EXPECT_NE(scene.impact.speed, 800.);
  EXPECT_DOUBLE_EQ(scene.contact.friction.static_coefficient, 0.3);
  expect_study_error("set Scenes = scenes/one.prm\nset Combine = one\n",
                     {"study.prm:3", "one at a time"});
}

TEST_F(StudyFile, PicturesAreDrawnUnlessToldOtherwise)
{
  EXPECT_TRUE(study("set Scenes = scenes/one.prm\n").pictures);
  EXPECT_FALSE(study("set Scenes = scenes/one.prm\nset Pictures = false\n").pictures);
}

TEST_F(StudyFile, ValuesMayContainCommas)
{
  const auto read = study("set Scenes = scenes/one.prm\n"
                          "set Axis 1 = Impact/Entry point: 40 mm, 0 mm | 60 mm, 0 mm\n");
  EXPECT_EQ(case_names(read),
            (Names{"one__entry_point_40_mm_0_mm", "one__entry_point_60_mm_0_mm"}));
}

TEST_F(StudyFile, AxisMayChangeSeveralEntriesTogether)
{
  const auto read =
      study("set Scenes = scenes/one.prm\n"
            "set Axis 1 = Contact/Static friction, Contact/Kinetic friction: 0.1 | 0.2\n");
  EXPECT_EQ(case_names(read), (Names{"one__static_friction_0.1", "one__static_friction_0.2"}));
  const Scene scene = read_scene(ParameterFile(read.cases[1].scene_file, read.cases[1].overrides));
  EXPECT_DOUBLE_EQ(scene.contact.friction.static_coefficient, 0.2);
  EXPECT_DOUBLE_EQ(scene.contact.friction.kinetic_coefficient, 0.2);
}

TEST_F(StudyFile, EqualNamesOfTwoAxesCarryTheirSection)
{
  folder.write("scenes/two_plates.prm", scene_text +
                                            "subsection Plate 2\nset Size = 100 mm, 100 mm, 20 mm\n"
                                            "set Grid spacing = 2 mm\nset Material = PMMA\nend\n");
  const auto read = study("set Scenes = scenes/two_plates.prm\n"
                          "set Axis 1 = Plate 1/Grid spacing: 2 mm\n"
                          "set Axis 2 = Plate 2/Grid spacing: 3 mm\n");
  EXPECT_EQ(case_names(read),
            (Names{"two_plates__plate_1_grid_spacing_2_mm__plate_2_grid_spacing_3_mm"}));
}

TEST_F(StudyFile, WrongScenesAreExplained)
{
  expect_study_error("", {"study.prm: An entry", "set Scenes = base.prm"});
  expect_study_error("set Scenes = three.prm\n", {"study.prm:2", "three.prm'", "relative"});
  expect_study_error("set Scenes = scenes/one.prm,\n", {"study.prm:2", "empty place"});
  expect_study_error("set Scenes = scenes/one.prm, scenes/one.prm\n",
                     {"study.prm:2", "Two cases", "'one'"});
}

TEST_F(StudyFile, WrongAxesAreExplained)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n";
  expect_study_error(scenes + "set Axis 1 = Impact/Speed 3 m/s\n",
                     {"study.prm:3", "No ':'", "Section/Entry: value | value"});
  expect_study_error(scenes + "set Axis 1 = : 3 m/s\n", {"study.prm:3", "name of an entry"});
  expect_study_error(scenes + "set Axis 1 = Impact/Speed: 3 m/s |\n",
                     {"study.prm:3", "A value is missing"});
  expect_study_error(scenes + "set Axis 1 = Impact/Speed: 3 m/s | 3 m/s\n",
                     {"study.prm:3", "'3 m/s'", "twice"});
  expect_study_error(scenes + "set Axis 1 = Impact/Speed: 3 m/s\n"
                              "set Axis 2 = Impact/Speed: 4 m/s\n",
                     {"study.prm:4 (Axis 2)", "set twice", "study.prm:3 (Axis 1)"});
}

TEST_F(StudyFile, EveryCaseIsReadBeforeTheFirstRuns)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n";
  expect_study_error(scenes + "set Axis 1 = Impact/Sped: 3 m/s\n",
                     {"study.prm:3 (Axis 1)", "did you mean 'Speed'?"});
  expect_study_error(
      scenes + "set Axis 1 = Plate 1/Horizon ratio: 3 | 1\n",
      {"study.prm:3 (Axis 1)", "A horizon under 2 spacings", "'one__horizon_ratio_1'"});
}

TEST_F(StudyFile, SceneIsNotAStudy)
{
  const std::string scene = folder.write("scene.prm", scene_text);
  expect_error([&] { read_study(scene); }, {"scene.prm", "'ricochet run'"});
}
} // namespace
} // namespace ricochet::tests
