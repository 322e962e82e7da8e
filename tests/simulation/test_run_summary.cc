// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/run_summary.h"

#include "ricochet/simulation/observation.h"
#include "support/similar_scene.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

std::string place_of(const SummaryField &field)
{
  return field.place + "|" + field.name;
}

TEST(RunSummary, FieldsAreToldApartAndExplained)
{
  std::set<std::string> all;
  for (const auto &field : summary_fields())
  {
    EXPECT_TRUE(all.insert(place_of(field)).second) << place_of(field);
    EXPECT_FALSE(field.meaning.empty()) << place_of(field);
  }
}

TEST(RunSummary, HasWhatTheListOfFieldsSays)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  OutcomeWatch watch = watch_of(simulation);
  simulation.compute_forces(true);
  watch.update(observe(simulation));
  const Totals totals = totals_of(simulation);
  RunNotes notes;
  notes.start_momenta = simulation.momenta();
  notes.positions.push_back(sighting(simulation, watch, 2e-6));
  notes.reference_data = {{"file", "exp.csv"}};
  notes.warnings       = {"careful"};
  const OutcomeVerdict verdict{Outcome::perforate, ExitFace::rear, 2, "a reason"};
  const Json summary = run_summary({simulation, watch, verdict, totals, notes},
                                   {{0.1, 1e-6, 2e-6}, {0.2, 3e-6, 4e-6, 0.75}});

  std::set<std::string> listed, present;
  for (const auto &field : summary_fields())
    if (field.place.empty())
      listed.insert(field.name);
    else if (field.place == "plate_N_")
      for (const char *plate : {"plate_1_", "plate_2_"})
        listed.insert(plate + field.name);
    else if (field.place.rfind("projectiles", 0) != 0)
    {
      EXPECT_TRUE(summary.contains(field.place)) << field.place;
      listed.insert(field.place);
    }
  for (const auto &[name, value] : summary.items())
    present.insert(name);
  listed.erase("plate_1_joint_broken_share"); // there is no plate above
  EXPECT_EQ(present, listed);
  EXPECT_EQ(summary["plate_2_joint_broken_share"], 0.75);

  EXPECT_EQ(summary["outcome"], "perforate");
  EXPECT_EQ(summary["exit_face"], "rear");
  EXPECT_EQ(summary["exit_plate"], 2);
  EXPECT_EQ(summary["momentum_drift"], 0.);
  EXPECT_TRUE(summary["on_elements_us"].is_null());
  EXPECT_DOUBLE_EQ(summary["plate_2_front_damaged_mm2"], 3.);
  EXPECT_EQ(summary["damaged_boxes_mm"], Json::array({Json::array(), Json::array()}));
  EXPECT_EQ(summary["positions"][0]["stated_us"], 2.);
  EXPECT_EQ(summary["positions"][0]["time_us"], 0.);
  // Plates without elements say no more of their zone.
  ASSERT_EQ(summary["zones"].size(), 2u);
  EXPECT_EQ(summary["zones"][0].size(), 2u);
  EXPECT_EQ(summary["zones"][0]["share_of_volume"], 1.);
}

TEST(RunSummary, OfSeveralProjectilesHasAnObjectOfEach)
{
  Scene scene = two_plates();
  scene.further_shots.push_back({scene.projectile, scene.impact});
  scene.further_shots[0].impact.entry_x = 22e-3;
  scene.further_shots[0].impact.speed   = 200.;
  Simulation simulation(MPI_COMM_WORLD, scene);
  std::vector<OutcomeWatch> watches{watch_of(simulation, 0), watch_of(simulation, 1)};
  simulation.compute_forces(true);
  for (const std::size_t i : {0, 1})
    watches[i].update(observe(simulation, i));
  RunNotes notes;
  notes.positions.push_back(sighting(simulation, watches[0], 0.));
  notes.further_positions.push_back(Json::array({sighting(simulation, watches[1], 0., 1)}));
  const OutcomeVerdict first{Outcome::perforate, ExitFace::rear, 2, "a reason"},
      second{Outcome::ricochet, ExitFace::front, 1, "another"};
  const Json summary =
      run_summary({simulation, watches[0], first, {}, notes, {{watches[1], second}}}, {});

  const auto &all = summary["projectiles"];
  ASSERT_EQ(all.size(), 2u);
  std::set<std::string> listed{"positions"}, present;
  for (const auto &field : summary_fields())
    if (field.place == "projectiles")
      listed.insert(field.name);
  for (const auto &[name, value] : all[1].items())
    present.insert(name);
  EXPECT_EQ(present, listed);
  for (const auto &[name, value] : all[0].items())
    EXPECT_EQ(summary[name], value) << name;
  EXPECT_EQ(all[1]["outcome"], "ricochet");
  EXPECT_EQ(all[1]["reason"], "another");
  EXPECT_NEAR(all[1]["exit_speed_m_s"], 200., 1e-12);
  EXPECT_NEAR(all[1]["positions"][0]["speed_m_s"], 200., 1e-12);
  EXPECT_NEAR(all[0]["positions"][0]["speed_m_s"], 300., 1e-12);
}

TEST(RunSummary, DamagedBoxesAreThoseOfSmallScenesToo)
{
  std::vector<double> boxes[2];
  for (const double length : {1., 0x1p-20}) // of micrometres
  {
    Simulation simulation(MPI_COMM_WORLD, similar(small_scene(), {length, 1., 1.}));
    for (int step = 0; step < 60; ++step)
    {
      simulation.compute_forces(false);
      simulation.advance();
    }
    const OutcomeWatch watch = watch_of(simulation);
    boxes[length < 1.] = run_summary({simulation, watch, {}, {}, {}}, {})["damaged_boxes_mm"][0]
                             .get<std::vector<double>>();
  }
  ASSERT_EQ(boxes[0].size(), 6u);
  ASSERT_EQ(boxes[1].size(), 6u);
  for (int i = 0; i < 6; ++i)
  {
    // Points lie in the middle of cubes of 1 mm.
    EXPECT_EQ(std::abs(std::remainder(boxes[0][i], 1.)), 0.5);
    EXPECT_DOUBLE_EQ(boxes[1][i], 0x1p-20 * boxes[0][i]);
  }
}

TEST(RunSummary, WithoutStatedTimesThereAreNoPositions)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  const OutcomeWatch watch = watch_of(simulation);
  const Json summary       = run_summary({simulation, watch, {}, {}, {}}, {});
  EXPECT_FALSE(summary.contains("positions"));
}
} // namespace
} // namespace ricochet::tests
