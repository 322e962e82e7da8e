// SPDX-License-Identifier: LGPL-2.1-or-later
// Comparison of ensembles, on summaries made up for it.
#include "commands/comparison.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// A run that has come to (x, y, z) [mm] at every 100 us, along a straight path from the origin;
/// its positions are noted so late [us], at 500 m/s and 30 degrees upwards.
Json run_to(const std::vector<std::vector<double>> &places, const double speed, const double cost,
            const std::string &outcome = "ricochet", const double late = 0.)
{
  const double flown = 0.5 * late, angle = std::acos(-1.) / 6.;
  Json positions = Json::array();
  for (std::size_t i = 0; i < places.size(); ++i)
    positions.push_back({{"stated_us", 100. * double(i + 1)},
                         {"time_us", 100. * double(i + 1) + late},
                         {"x_mm", places[i][0] + flown * std::cos(angle)},
                         {"y_mm", places[i][1]},
                         {"z_mm", places[i][2] + flown * std::sin(angle)},
                         {"path_mm", std::hypot(places[i][0], places[i][1], places[i][2]) + flown},
                         {"speed_m_s", 500.},
                         {"angle_deg", 30.}});
  Json run{{"title", "Test"},      {"outcome", outcome}, {"exit_speed_m_s", speed},
           {"core_seconds", cost}, {"failed", false},    {"interrupted", false}};
  if (!places.empty())
    run["positions"] = positions;
  return run;
}

TEST(Comparison, PathErrorIsTheDistanceOfMeanPositionsOverTheReferencesPath)
{
  // Means (100, 0, 0) and (103, 0, 4): distance 5 mm on a path of 100 mm.
  const Ensemble reference{run_to({{99., 0., 0.}}, 300., 8.), run_to({{101., 0., 0.}}, 300., 8.)};
  const Ensemble runs{run_to({{103., 0., 0.}}, 300., 2.), run_to({{103., 0., 8.}}, 300., 2.)};
  const auto errors = path_errors(runs, reference);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_DOUBLE_EQ(errors[0].stated_time, 100.);
  EXPECT_DOUBLE_EQ(errors[0].path, 100.);
  EXPECT_NEAR(errors[0].error, 0.05, 1e-12);
  EXPECT_NEAR(errors[0].low, 0.03, 1e-12);
  EXPECT_NEAR(errors[0].high, std::hypot(3., 8.) / 100., 1e-12);
  EXPECT_NEAR(errors[0].scatter, 0.01, 1e-12);
}

TEST(Comparison, WhatIsNotedInTheStepAfterAStatedTimeIsTakenBackToIt)
{
  const std::vector<std::vector<double>> places{{5., 0., -1.}};
  const Ensemble reference{run_to(places, 300., 8.)},
      runs{run_to(places, 300., 8., "ricochet", /*late=*/0.36)};
  const auto errors = path_errors(runs, reference), back = path_errors(reference, runs);
  EXPECT_NEAR(errors.at(0).error, 0., 1e-12);
  EXPECT_NEAR(back.at(0).path, errors[0].path, 1e-12);
}

TEST(Comparison, PathsAreComparedAtTheLatestTimeThatAllRunsHaveReached)
{
  const std::vector<std::vector<double>> three{{50., 0., 0.}, {100., 0., 0.}, {150., 0., 0.}},
      two{{50., 0., 0.}, {100., 0., 2.}};
  const Ensemble reference{run_to(three, 300., 8.), run_to(three, 300., 8.)};
  const Ensemble runs{run_to(three, 300., 2.), run_to(two, 300., 2.)};
  const Json row = compare(runs, reference);
  EXPECT_EQ(row["compared_at_us"], 200.);
  EXPECT_EQ(row["reference_path_mm"], 100.);
  EXPECT_NEAR(row["path_error_percent"].get<double>(), 1., 1e-12);
  EXPECT_NEAR(row["path_error_low_percent"].get<double>(), 0., 1e-12);
  EXPECT_NEAR(row["path_error_high_percent"].get<double>(), 2., 1e-12);
  EXPECT_EQ(row["reference_scatter_percent"], 0.);
  // The reference with itself reaches further.
  EXPECT_EQ(compare(reference, reference)["compared_at_us"], 300.);
  EXPECT_EQ(compare(reference, reference)["path_error_percent"], 0.);
}

TEST(Comparison, MissingPositionsAreNull)
{
  const Ensemble with{run_to({{50., 0., 0.}}, 300., 8.)}, without{run_to({}, 290., 2.)};
  for (const auto &row : {compare(without, with), compare(with, without)})
  {
    EXPECT_TRUE(row["compared_at_us"].is_null());
    EXPECT_TRUE(row["path_error_percent"].is_null());
    EXPECT_FALSE(row["exit_speed_error_percent"].is_null());
  }
  // A single run has no scatter.
  EXPECT_TRUE(compare(with, with)["reference_scatter_percent"].is_null());
  EXPECT_EQ(compare(with, with)["path_error_percent"], 0.);
}

TEST(Comparison, SpeedsAndCostsAreMediansWithTheirRange)
{
  Ensemble reference, runs;
  for (const double speed : {300., 310., 110., 320.})
    reference.push_back(run_to({}, speed, speed / 100.));
  for (const double speed : {330., 300., 100.})
    runs.push_back(run_to({}, speed, 1.));
  const Json own = compare(reference, reference);
  EXPECT_EQ(own["runs"], 4);
  EXPECT_DOUBLE_EQ(own["exit_speed_m_s"], 305.);
  EXPECT_DOUBLE_EQ(own["exit_speed_low_m_s"], 110.);
  EXPECT_DOUBLE_EQ(own["exit_speed_high_m_s"], 320.);
  EXPECT_DOUBLE_EQ(own["cost_ratio"], 1.);
  const Json row = compare(runs, reference);
  EXPECT_DOUBLE_EQ(row["exit_speed_m_s"], 300.);
  EXPECT_NEAR(row["exit_speed_error_percent"].get<double>(), -100. * 5. / 305., 1e-12);
  EXPECT_DOUBLE_EQ(row["core_seconds"], 1.);
  EXPECT_NEAR(row["cost_ratio"].get<double>(), 1. / 3.05, 1e-12);
}

TEST(Comparison, OutcomesAreCountedAndSpeedsOfThoseThatHaveNotLeftAreNone)
{
  const Ensemble reference{run_to({}, 300., 1.), run_to({}, 310., 1.), run_to({}, 290., 1.)};
  const Ensemble runs{run_to({}, 320., 1., "perforate"), run_to({}, 20., 1., "undecided"),
                      run_to({}, 5., 1., "stuck"), run_to({}, 310., 1.)};
  const Json row = compare(runs, reference);
  EXPECT_EQ(row["outcomes"], "1 perforate, 1 ricochet, 1 stuck, 1 undecided");
  EXPECT_DOUBLE_EQ(row["same_outcome"], 0.25);
  EXPECT_DOUBLE_EQ(row["exit_speed_m_s"], 315.);
  EXPECT_DOUBLE_EQ(row["exit_speed_low_m_s"], 310.);

  // No run has left, and an undecided or divided reference has no outcome to agree with.
  const Ensemble undecided{runs[1]}, divided{runs[0], runs[3]};
  EXPECT_TRUE(compare(undecided, reference)["exit_speed_m_s"].is_null());
  EXPECT_TRUE(compare(undecided, reference)["exit_speed_error_percent"].is_null());
  EXPECT_EQ(compare(undecided, reference)["same_outcome"], 0.);
  EXPECT_TRUE(compare(reference, undecided)["same_outcome"].is_null());
  EXPECT_TRUE(compare(reference, undecided)["exit_speed_error_percent"].is_null());
  EXPECT_TRUE(compare(reference, divided)["same_outcome"].is_null());
}

TEST(Comparison, WithoutRunsEverythingIsNull)
{
  const Ensemble reference{run_to({{50., 0., 0.}}, 300., 8.)};
  const Json row = compare(Ensemble(), reference);
  EXPECT_EQ(row["runs"], 0);
  for (const char *name : {"outcomes", "same_outcome", "path_error_percent", "exit_speed_m_s",
                           "core_seconds", "cost_ratio"})
    EXPECT_TRUE(row[name].is_null()) << name;
}

/// Two scenes, two speeds, two runs of each.
StudyParameters small_study()
{
  StudyParameters study{};
  study.reference = "full";
  study.axes      = {{{{"Impact", "Speed", "", ""}}, {"700 m/s", "800 m/s"}, false},
                     {{{"Time", "Safety factor", "", ""}}, {"0.6", "0.7"}, true}};
  for (std::size_t speed : {0, 1})
    for (std::size_t factor : {0, 1})
      for (const char *scene : {"full", "zone"})
      {
        StudyCase one;
        one.scene  = scene;
        one.values = {speed, factor};
        study.cases.push_back(one);
      }
  return study;
}

TEST(Comparison, ScenesMeetTheReferenceUnderTheSameValues)
{
  std::vector<Json> summaries;
  for (const double x : {100., 200.}) // the path of the reference under the first, second speed
    for (int factor = 0; factor < 2; ++factor)
      for (const double more : {0., 0.01})
        summaries.push_back(run_to({{x * (1. + more), 0., 0.}}, 300., 1.));
  const Comparison comparison = compare_scenes(small_study(), summaries);
  std::vector<std::string> lines;
  std::istringstream csv(comparison.csv);
  for (std::string line; std::getline(csv, line);)
    lines.push_back(line);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0].rfind("case,scene,group,title,reference,runs,outcomes,same_outcome,", 0), 0U);
  EXPECT_EQ(lines[2].rfind("zone__speed_700_m_s,zone,700 m/s,Test,full__speed_700_m_s,2,"
                           "2 ricochet,1.0,100.0,100.0,1.0,",
                           0),
            0U)
      << lines[2];
  EXPECT_EQ(lines[4].rfind("zone__speed_800_m_s,zone,800 m/s,Test,full__speed_800_m_s,2,"
                           "2 ricochet,1.0,100.0,200.0,1.0,",
                           0),
            0U)
      << lines[4];
}

TEST(Comparison, FailedAndInterruptedRunsDoNotTakePart)
{
  std::vector<Json> summaries(8, run_to({{100., 0., 0.}}, 300., 1.));
  summaries[1]                = nullptr; // zone, 700 m/s, first
  summaries[2]["failed"]      = true;    // full, 700 m/s, second
  summaries[3]["interrupted"] = true;    // zone, 700 m/s, second
  const Comparison comparison = compare_scenes(small_study(), summaries);
  EXPECT_NE(comparison.csv.find("\nfull__speed_700_m_s,full,700 m/s,Test,"
                                "full__speed_700_m_s,1,1 ricochet,"),
            std::string::npos)
      << comparison.csv;
  EXPECT_NE(comparison.csv.find("\nzone__speed_700_m_s,zone,700 m/s,-,"
                                "full__speed_700_m_s,0,-,-,-,"),
            std::string::npos)
      << comparison.csv;
  EXPECT_NE(comparison.text.find("1 of 2"), std::string::npos) << comparison.text;
}
} // namespace
} // namespace ricochet
