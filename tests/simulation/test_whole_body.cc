// SPDX-License-Identifier: LGPL-2.1-or-later
// What is reported of a scene is reported of whole bodies, whether or not a symmetry plane spares
// the computation of one half.
#include "ricochet/simulation/run_summary.h"

#include "ricochet/simulation/observation.h"
#include "support/coupled_scene.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

/// Numbers with their units.
struct Report
{
  std::map<std::string, double> values;
  std::map<std::string, std::string> units;

  void add(const std::string &name, const std::string &unit, const Json &value)
  {
    if (value.is_array())
      for (std::size_t i = 0; i < value.size(); ++i)
        add(name + "[" + std::to_string(i) + "]", unit, value[i]);
    else if (value.is_number())
    {
      values[name] = value;
      units[name]  = unit;
    }
  }

  /// Of what is measured in that unit, the largest.
  double scale(const std::string &unit) const
  {
    double largest = 0.;
    for (const auto &[name, value] : values)
      if (units.at(name) == unit)
        largest = std::max(largest, std::abs(value));
    return largest;
  }
};

void add_fields(const Json &summary, Report &report)
{
  for (const auto &field : summary_fields())
    if (field.place.empty())
      report.add(field.name, field.unit, summary.value(field.name, Json()));
    else if (field.place == "zones")
      for (std::size_t i = 0; i < summary["zones"].size(); ++i)
        report.add("zones[" + std::to_string(i) + "]." + field.name, field.unit,
                   summary["zones"][i].value(field.name, Json()));
    else if (field.place == "plate_N_")
      for (std::size_t i = 0; i < summary["zones"].size(); ++i)
      {
        const std::string name = "plate_" + std::to_string(i + 1) + "_" + field.name;
        report.add(name, field.unit, summary.value(name, Json()));
      }
}

/// What history and summary say after so many steps; nothing of what a run costs.
Report report_of(const Scene &scene, const int n_steps)
{
  Simulation simulation(MPI_COMM_WORLD, scene);
  OutcomeWatch watch = watch_of(simulation);
  DamageReport damage(MPI_COMM_WORLD, simulation);
  RunNotes notes;
  notes.n_points      = simulation.n_points();
  notes.n_bonds       = damage.n_bonds();
  notes.start_momenta = simulation.momenta();
  for (int i = 0; i < n_steps; ++i)
  {
    simulation.compute_forces(false);
    watch.update(observe(simulation));
    simulation.advance();
  }
  simulation.compute_forces(true);
  const Totals totals = totals_of(simulation);
  HourglassWatch hourglass;
  hourglass.update({simulation, totals});
  notes.hourglass = hourglass.largest();
  Report report;
  const auto record = history_record({simulation, totals});
  for (std::size_t i = 0; i < record.size(); ++i)
    report.add("history: " + history_columns()[i].name, history_columns()[i].unit, record[i]);
  add_fields(run_summary({simulation, watch, watch.verdict(""), totals, notes}, damage.plates()),
             report);
  // Drifts are rounding in units of themselves.
  for (const char *name : {"momentum_drift", "angular_momentum_drift"})
    report.values.erase(name);
  return report;
}

/// Calibration stops somewhere near its minimum, elsewhere in the half than in the whole.
Scene coupled_without_calibration()
{
  Scene scene                = coupled_scene();
  scene.zone.coupling.method = CouplingMethod::energy_blend;
  return scene;
}

Scene clamped(Scene scene)
{
  for (auto &plate : scene.plates)
    plate.clamped_sides = ClampedSides::all;
  return scene;
}

class WholeBody : public testing::TestWithParam<Scene>
{
};

INSTANTIATE_TEST_SUITE_P(
    Scenes, WholeBody,
    testing::Values(two_plates(), clamped(two_plates()), coupled_without_calibration(),
                    deformable(small_scene()), peridynamic_nose(small_scene())),
    [](const auto &info)
    {
      return std::string(info.param.zone.has_elements() ? "Coupled" : "") +
             (info.param.plates[0].clamped_sides == ClampedSides::none ? "" : "Clamped") +
             model_name(info.param);
    });

TEST_P(WholeBody, IsWhatHistoryAndSummaryTellWithAndWithoutTheSymmetryPlane)
{
  // Both with the same step, see HalfModel in test_simulation.cc.
  const Scene full = GetParam();
  Scene half       = symmetric(full);
  half.time.safety_factor *=
      Simulation(MPI_COMM_WORLD, full).dt() / Simulation(MPI_COMM_WORLD, half).dt();
  constexpr int n_steps = 100;
  const Report whole = report_of(full, n_steps), mirrored = report_of(half, n_steps);
  EXPECT_GT(whole.values.at("points"), 0.);
  EXPECT_GT(whole.values.at("broken_bonds"), 100.);
  ASSERT_EQ(whole.units, mirrored.units);
  for (const auto &[name, value] : whole.values)
  {
    // Sums are made in another order; debris amplifies that tenfold in 30 steps. Counts are exact.
    const std::string unit = whole.units.at(name);
    const double tolerance =
        value == std::round(value) && unit == "-" ? 0. : 1e-10 * whole.scale(unit);
    EXPECT_NEAR(mirrored.values.at(name), value, tolerance) << name << " [" << unit << "]";
  }
}
} // namespace
} // namespace ricochet::tests
