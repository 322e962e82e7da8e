// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/study_file.h"

#include "ricochet/scene/scene_reader.h"
#include "support/scene_text.h"

#include <cmath>

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
  const Scene scene = read_scene(last.file);
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
  EXPECT_EQ(read.combination, Combination::one_at_a_time);
  EXPECT_EQ(case_names(read),
            (Names{"one", "one__speed_700_m_s", "one__speed_800_m_s", "one__static_friction_0.3",
                   "two", "two__speed_700_m_s", "two__speed_800_m_s", "two__static_friction_0.3"}));
  const Scene scene = read_scene(read.cases[3].file);
  EXPECT_NE(scene.impact.speed, 800.);
  EXPECT_DOUBLE_EQ(
      std::get<ExponentialFriction::Parameters>(scene.contact.friction).static_coefficient, 0.3);
  expect_study_error("set Scenes = scenes/one.prm\nset Combine = one\n",
                     {"study.prm:3", "one at a time"});
}

/// The numbers of one column, and NaN for words.
std::vector<double> numbers_of(const StudyParameters &study, const std::size_t column)
{
  std::vector<double> numbers;
  for (const auto &one : study.cases)
    numbers.push_back(one.axis_values.at(column).number.value_or(std::nan("")));
  return numbers;
}

TEST_F(StudyFile, AxesHaveColumnsWithTheUnitOfTheirFirstValue)
{
  const auto read = study("set Scenes = scenes/one.prm\n"
                          "set Axis 1 = Impact/Speed: 0.5 km/s | 800 m/s\n"
                          "set Axis 2 = Contact/Static friction, Contact/Kinetic friction: 0.1\n"
                          "set Axis 3 = Projectile/Nose shape: ogive\n");
  ASSERT_EQ(read.axis_columns.size(), 3u);
  EXPECT_EQ(read.axis_columns[0].name, "speed_km_s");
  EXPECT_EQ(read.axis_columns[0].label, "speed");
  EXPECT_EQ(read.axis_columns[0].unit, "km/s");
  EXPECT_EQ(read.axis_columns[1].name, "static_friction");
  EXPECT_TRUE(read.axis_columns[1].is_number);
  EXPECT_EQ(read.axis_columns[2].name, "nose_shape");
  EXPECT_FALSE(read.axis_columns[2].is_number);
  EXPECT_EQ(numbers_of(read, 0), (std::vector<double>{0.5, 0.8}));
  EXPECT_EQ(read.cases[1].axis_values[2].text, "ogive");
  EXPECT_EQ(read.cases[1].label, "800 m/s, static friction 0.1, nose shape ogive");
}

TEST_F(StudyFile, EntriesWithValuesOfTheirOwnHaveColumnsOfTheirOwn)
{
  const auto read = study("set Scenes = scenes/one.prm, scenes/two.prm\n"
                          "set Axis 1 = Impact/Speed, Impact/Incidence angle: "
                          "700 m/s; 45 deg | 800 m/s; 30 deg\n");
  ASSERT_EQ(read.axis_columns.size(), 2u);
  EXPECT_EQ(read.axis_columns[1].name, "incidence_angle_deg");
  EXPECT_EQ(numbers_of(read, 1), (std::vector<double>{45., 30., 45., 30.}));
  EXPECT_EQ(read.cases[2].label, "two, 700 m/s, 45 deg");
}

TEST_F(StudyFile, WhatAnAxisLeavesAloneHasTheScenesOwnValue)
{
  const auto read = study("set Scenes = scenes/one.prm\nset Combine = one at a time\n"
                          "set Axis 1 = Impact/Speed: 700 m/s\n"
                          "set Axis 2 = Time/Safety factor: 0.5\n");
  EXPECT_EQ(numbers_of(read, 0), (std::vector<double>{720., 700., 720.})); // 0.72 mm/us
  EXPECT_EQ(numbers_of(read, 1), (std::vector<double>{0.7, 0.7, 0.5}));    // the default
  EXPECT_EQ(read.cases[0].label, "one");
}

TEST_F(StudyFile, RangesStandForTheirMembers)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n";
  const auto read =
      study(scenes + "set Axis 1 = Impact/Speed: 300 m/s | 500 m/s to 0.6 km/s step 50 m/s\n"
                     "set Axis 2 = Time/Safety factor: 0.6 to 0.72 step 0.04\n");
  EXPECT_EQ(read.axes[0].values, (Names{"300 m/s", "500 m/s", "550 m/s", "600 m/s"}));
  EXPECT_EQ(read.axes[1].values, (Names{"0.6", "0.64", "0.68", "0.72"}));
  EXPECT_EQ(study(scenes + "set Axis 1 = Impact/Incidence angle: 30 deg to 10 deg step -10 deg\n")
                .axes[0]
                .values,
            (Names{"30 deg", "20 deg", "10 deg"}));
  const auto range = [&](const std::string &text)
  { return scenes + "set Axis 1 = Impact/Speed: " + text + "\n"; };
  expect_study_error(range("500 m/s to 610 m/s step 50 m/s"),
                     {"study.prm:3", "does not meet its last value", "End at 600 m/s"});
  expect_study_error(range("500 m/s to 600 m/s step 0 m/s"), {"study.prm:3", "at least one"});
  expect_study_error(range("500 m/s to 600 m/s step -50 m/s"), {"study.prm:3", "at least one"});
  expect_study_error(range("1 m/s to 5000 m/s step 1 m/s"), {"less than 1000 steps"});
  expect_study_error(range("500 m/s to 600 mm step 50 m/s"), {"study.prm:3", "mixes units"});
  expect_study_error(range("500 m/s to fast step 50 m/s"), {"'fast'", "no number"});
  expect_study_error(range("500 m/s to 600 m/s"),
                     {"neither a value nor a complete range", "500 m/s to 900 m/s step 50 m/s"});
}

TEST_F(StudyFile, ZippedAxesGoSideBySide)
{
  const std::string axes = "set Scenes = scenes/one.prm\nset Combine = zipped\n"
                           "set Axis 1 = Impact/Speed: 700 m/s | 800 m/s\n";
  EXPECT_EQ(case_names(study(axes + "set Axis 2 = Impact/Incidence angle: 45 deg | 30 deg\n")),
            (Names{"one__speed_700_m_s__incidence_angle_45_deg",
                   "one__speed_800_m_s__incidence_angle_30_deg"}));
  expect_study_error(axes + "set Axis 2 = Impact/Incidence angle: 45 deg\n",
                     {"study.prm:5", "has 1 values, but 'Axis 1' has 2", "equally many"});
}

TEST_F(StudyFile, UnknownColumnsAreExplained)
{
  const auto read = study("set Scenes = scenes/one.prm\nset Columns = outcome, exit_sped_m_s\n");
  check_columns(read, {"outcome", "exit_sped_m_s"});
  expect_error(
      [&] {
        check_columns(read, {"outcome", "exit_speed_m_s"});
      },
      {"study.prm:3", "Study/Columns = 'exit_sped_m_s'", "did you mean 'exit_speed_m_s'?",
       "'ricochet columns'"});
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
  const Scene scene    = read_scene(read.cases[1].file);
  const auto &friction = std::get<ExponentialFriction::Parameters>(scene.contact.friction);
  EXPECT_DOUBLE_EQ(friction.static_coefficient, 0.2);
  EXPECT_DOUBLE_EQ(friction.kinetic_coefficient, 0.2);
}

TEST_F(StudyFile, AxisMayGiveEachOfItsEntriesItsOwnValue)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n";
  const auto read          = study(scenes + "set Axis 1 = Impact/Speed, Impact/Incidence angle: "
                                                     "700 m/s; 45 deg | 800 m/s; 30 deg\n");
  EXPECT_EQ(case_names(read), (Names{"one__speed_700_m_s_45_deg", "one__speed_800_m_s_30_deg"}));
  const Scene scene = read_scene(read.cases[0].file);
  EXPECT_DOUBLE_EQ(scene.impact.speed, 700.);
  EXPECT_NEAR(scene.impact.incidence_angle, std::acos(-1.) / 4., 1e-12);
  expect_study_error(scenes + "set Axis 1 = Impact/Speed: 700 m/s; 45 deg\n",
                     {"study.prm:3", "2 values to 1 entries", "one for each with ';'"});
}

TEST_F(StudyFile, SettingsHoldInAllCases)
{
  const std::string scenes = "set Scenes = scenes/one.prm, scenes/two.prm\n";
  const auto read =
      study(scenes + "set Settings = Impact/Speed: 650 m/s; Output/Pictures: false\n");
  EXPECT_EQ(case_names(read), (Names{"one", "two"}));
  for (const auto &one : read.cases)
  {
    const Scene scene = read_scene(one.file);
    EXPECT_DOUBLE_EQ(scene.impact.speed, 650.);
    EXPECT_FALSE(scene.output.pictures);
  }
  expect_study_error(scenes + "set Settings = Impact/Speed 650 m/s\n",
                     {"study.prm:3", "'Impact/Speed 650 m/s' is no entry", "Section/Entry: value"});
  expect_study_error(scenes + "set Settings = Impact/Speed: 650 m/s;\n",
                     {"study.prm:3", "is no entry"});
  expect_study_error(scenes + "set Settings = Impact/Sped: 650 m/s\n",
                     {"study.prm:3 (Settings)", "did you mean 'Speed'?"});
  expect_study_error(scenes + "set Settings = Impact/Speed: 650 m/s\n"
                              "set Axis 1 = Impact/Speed: 700 m/s\n",
                     {"study.prm:3 (Settings)", "set twice", "study.prm:4 (Axis 1)"});
}

const std::string compared = "set Scenes = scenes/one.prm, scenes/two.prm\n"
                             "set Axis 1 = Impact/Speed: 700 m/s | 800 m/s\n"
                             "set Axis 2 = Time/Safety factor: 0.6 | 0.7\n";

TEST_F(StudyFile, ComparedScenesRunOneAfterTheOther)
{
  EXPECT_EQ(study(compared).reference, "");
  const auto read = study(compared + "set Reference = scenes/two.prm\nset Ensemble = Axis 2\n");
  EXPECT_EQ(read.reference, "two");
  EXPECT_FALSE(read.axes[0].is_ensemble);
  EXPECT_TRUE(read.axes[1].is_ensemble);
  EXPECT_EQ(
      case_names(read),
      (Names{"one__speed_700_m_s__safety_factor_0.6", "two__speed_700_m_s__safety_factor_0.6",
             "one__speed_700_m_s__safety_factor_0.7", "two__speed_700_m_s__safety_factor_0.7",
             "one__speed_800_m_s__safety_factor_0.6", "two__speed_800_m_s__safety_factor_0.6",
             "one__speed_800_m_s__safety_factor_0.7", "two__speed_800_m_s__safety_factor_0.7"}));
  EXPECT_EQ(read.cases[5].scene, "two");
  EXPECT_EQ(group_name(read, read.cases[1]), "speed_700_m_s");
  EXPECT_EQ(group_name(read, read.cases[7]), "speed_800_m_s");

  const auto single = study(compared + "set Reference = scenes/one.prm\n");
  EXPECT_EQ(group_name(single, single.cases[1]), "speed_700_m_s__safety_factor_0.6");
  EXPECT_EQ(group_title(single, single.cases[1]), "700 m/s, safety factor 0.6");
}

TEST_F(StudyFile, WrongComparisonsAreExplained)
{
  expect_study_error(compared + "set Reference = scenes/three.prm\n",
                     {"study.prm:5", "'scenes/three.prm' is not among the scenes",
                      "scenes/one.prm or scenes/two.prm"});
  expect_study_error("set Scenes = scenes/one.prm\nset Reference = scenes/one.prm\n",
                     {"study.prm:3", "nothing to compare", "Add another scene"});
  expect_study_error(compared + "set Combine = one at a time\nset Reference = scenes/one.prm\n",
                     {"study.prm:6", "one at a time", "Remove 'Combine'"});
  expect_study_error(compared + "set Ensemble = Axis 2\n",
                     {"study.prm:5", "no reference", "set Reference = scenes/one.prm"});
  expect_study_error(compared + "set Reference = scenes/one.prm\nset Ensemble = Axis 3\n",
                     {"study.prm:6", "'Axis 3' is no axis", "Axis 1 or Axis 2"});
  expect_study_error("set Scenes = scenes/one.prm, scenes/two.prm\n"
                     "set Reference = scenes/one.prm\nset Ensemble = Axis 1\n",
                     {"study.prm:4", "has no axis", "Time/Safety factor"});
  folder.write("scenes/noise.prm", "subsection Stability\nend\n");
  expect_study_error("set Scenes = scenes/one.prm, scenes/noise.prm\n"
                     "set Reference = scenes/one.prm\n",
                     {"noise.prm", "stability experiment has no path", "'noise'"});
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

TEST_F(StudyFile, CasesHoldWhatHasBeenRead)
{
  folder.write("scenes/noise.prm", "subsection Stability\nend\n");
  const auto read = study("set Scenes = scenes/one.prm, scenes/noise.prm\n");
  EXPECT_FALSE(read.cases[0].is_experiment);
  EXPECT_TRUE(read.cases[1].is_experiment);
  folder.write("scenes/one.prm", "no longer a scene\n"); // nobody looks again
  EXPECT_EQ(read_scene(read.cases[0].file).output.directory, "output/study/one");
}

TEST_F(StudyFile, EntriesStandInTheSection)
{
  expect_error(
      [&]
      {
        read_study(folder.write("top.prm", "set Title = x\nsubsection Study\n"
                                           "set Scenes = scenes/one.prm\nend\n"));
      },
      {"top.prm:1", "no entry 'Title' outside the sections", "'Study/Title'"});
}

TEST_F(StudyFile, AnAxisMayFollowFromAnother)
{
  const auto read = study("set Scenes = scenes/one.prm\n"
                          "set Axis 1 = Plate 1/Grid spacing: 2.5 mm | 2.0 mm\n"
                          "set Axis 2 = Projectile/Nose length: = 4 * Axis 1\n"
                          "set Axis 3 = Impact/Speed: 500 m/s | 600 m/s\n");
  ASSERT_EQ(read.cases.size(), 4u); // it adds none
  EXPECT_EQ(read.axes[0].values, (Names{"2.5 mm; 10 mm", "2.0 mm; 8 mm"}));
  const auto halved = study("set Scenes = scenes/one.prm\n"
                            "set Axis 1 = Projectile/Diameter: = Axis 2 / 2\n"
                            "set Axis 2 = Projectile/Nose length, Plate 1/Grid spacing: 5 mm\n");
  EXPECT_EQ(halved.axes[0].values, (Names{"5 mm; 5 mm; 2.5 mm"}));
  for (const std::string wrong :
       {"= 4 * Axis 3", "= 4 * Axis 2", "= 2 mm * Axis 1", "= 0 * Axis 1", "= 2 / Axis 1", "= 3"})
    expect_study_error("set Scenes = scenes/one.prm\n"
                       "set Axis 1 = Plate 1/Grid spacing: 2.5 mm | 2.0 mm\n"
                       "set Axis 2 = Projectile/Nose length: " +
                           wrong + "\n",
                       {"Axis 2", "does not follow from an axis", "'= 4 * Axis 1'"});
}

TEST_F(StudyFile, ALimitIsAnAxisThatGrows)
{
  auto read = study("set Scenes = scenes/one.prm\n"
                    "set Axis 1 = Impact/Incidence angle: 20 deg | 30 deg\n"
                    "set Find limit = Impact/Speed between ricochet and perforate\n"
                    "set Limit range = 500 m/s to 0.9 mm/us\nset Limit tolerance = 10 m/s\n");
  EXPECT_EQ(read.axis_columns.back().name, "speed_m_s");
  ASSERT_EQ(read.cases.size(), 4u);
  EXPECT_EQ(read.cases[1].name, "one__incidence_angle_20_deg__speed_900_m_s");
  add_limit_case(read, 3, 700.);
  EXPECT_EQ(read.cases.back().name, "one__incidence_angle_30_deg__speed_700_m_s");
  EXPECT_DOUBLE_EQ(read_scene(read.cases.back().file).impact.speed, 700.);
  EXPECT_EQ(read.cases.back().values, (std::vector<std::size_t>{1, 2}));
}

TEST_F(StudyFile, WrongLimitsAreExplained)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n";
  const auto expect        = [&](const std::string &limit, const std::string &range,
                          const std::string &tolerance, const std::vector<std::string> &parts)
  {
    expect_study_error(scenes + "set Find limit = " + limit + "\nset Limit range = " + range +
                           "\nset Limit tolerance = " + tolerance + "\n",
                       parts);
  };
  const std::string good = "Impact/Speed between ricochet and perforate";
  expect(good, "900 m/s to 500 m/s", "10 m/s", {"study.prm:4", "'500 m/s to 900 m/s'"});
  expect(good, "500 m/s to 900", "10 m/s", {"unit does not go with"});
  expect(good, "500 m/s", "10 m/s", {"no two ends"});
  expect(good, "500 m/s to 900 m/s", "400 m/s", {"study.prm:5", "narrower than the range"});
  expect("Impact/Speed between ricochet and perforated", "1 m/s to 2 m/s", "1 mm/s",
         {"did you mean 'perforate'?"});
  expect("Impact/Speed between stuck and stuck", "1 m/s to 2 m/s", "1 mm/s", {"an outcome and"});
  expect("Impact/Sped between stuck and edge", "1 m/s to 2 m/s", "0.1 m/s", {"Speed"});
  expect_study_error(scenes + "set Limit range = 1 m/s to 2 m/s\n", {"go together"});
  expect_study_error(scenes + "set Axis 1 = Impact/Speed: 1 m/s\nset Find limit = " + good +
                         "\nset Limit range = 1 m/s to 2 m/s\nset Limit tolerance = 0.1 m/s\n",
                     {"is an axis of the study, too"});
}

TEST_F(StudyFile, KindsNeedTheirAxes)
{
  const std::string scenes = "set Scenes = scenes/one.prm\n",
                    speeds = "set Axis 1 = Impact/Speed: 500 m/s | 600 m/s\n",
                    angles = "set Axis 2 = Impact/Incidence angle: 20 deg | 30 deg\n";
  EXPECT_EQ(study(scenes + speeds + angles + "set Kind = map\n").kind, StudyKind::map);
  expect_study_error(scenes + speeds + "set Kind = map\n",
                     {"Study/Kind", "two axes of numbers", "has 1", "Axis 2"});
  expect_study_error(scenes + speeds + "set Kind = mapp\n", {"'map'"});
  const std::string grids = "set Axis 1 = Plate 1/Grid spacing: 2.5 mm | 1 mm | 2 mm\n",
                    kind  = "set Kind = convergence\n";
  EXPECT_EQ(study(scenes + grids + kind).finest, 1u);
  EXPECT_EQ(study(scenes + grids + kind + "set Reference = 2 mm\n").finest, 2u);
  expect_study_error(scenes + grids + kind + "set Reference = 3 mm\n", {"'Axis 1'", "1 mm"});
  expect_study_error(scenes + kind, {"no axis to refine"});
  expect_study_error(scenes + kind + "set Axis 1 = Contact/Friction law: exponential | constant\n",
                     {"no number above 0"});
  expect_study_error(scenes + kind + "set Axis 1 = Impact/Speed: 500 m/s\n", {"a single value"});
}

TEST_F(StudyFile, SceneIsNotAStudy)
{
  const std::string scene = folder.write("scene.prm", scene_text);
  expect_error([&] { read_study(scene); }, {"scene.prm", "'ricochet run'"});
}
} // namespace
} // namespace ricochet::tests
