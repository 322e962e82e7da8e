// SPDX-License-Identifier: LGPL-2.1-or-later
// The section 'Stability'.
#include "ricochet/scene/stability_reader.h"

#include "support/scene_text.h"

#include <sstream>

namespace ricochet::tests
{
namespace
{
ParameterFile experiment_with(const std::vector<std::string> &overrides)
{
  return ParameterFile::from_text("subsection Stability\nend\n", "noise.prm",
                                  parse_overrides(overrides));
}

StabilityParameters read_experiment(const std::vector<std::string> &overrides)
{
  return read_stability(experiment_with(overrides));
}

void expect_refused(const std::string &override, const std::vector<std::string> &parts)
{
  expect_error([&] { read_experiment({"Stability/" + override}); }, parts);
}

/// A default stands in the row for users and in the member for programs.
TEST(StabilitySection, DefaultsAreThoseOfTheMembers)
{
  const StabilityParameters read = read_experiment({}), own;
  EXPECT_EQ(read.title, "noise");
  EXPECT_EQ(read.directory, "output/noise");
  EXPECT_EQ(read.coupling.method, own.coupling.method);
  EXPECT_EQ(read.coupling.blend, own.coupling.blend);
  EXPECT_EQ(read.coupling.blend_width, own.coupling.blend_width);
  EXPECT_EQ(read.coupling.correct_mass, own.coupling.correct_mass);
  EXPECT_EQ(read.coupling.points_per_edge, own.coupling.points_per_edge);
  EXPECT_EQ(read.coupling.calibration.n_iterations, own.coupling.calibration.n_iterations);
  EXPECT_EQ(read.coupling.calibration.tolerance, own.coupling.calibration.tolerance);
  EXPECT_EQ(read.coupling.calibration.clip, own.coupling.calibration.clip);
  EXPECT_EQ(read.full_quadrature, own.full_quadrature);
  EXPECT_EQ(read.hourglass_coefficient, own.hourglass_coefficient);
  EXPECT_DOUBLE_EQ(read.spacing, own.spacing);
  EXPECT_EQ(read.horizon_ratio, own.horizon_ratio);
  EXPECT_EQ(read.influence, own.influence);
  EXPECT_EQ(read.density, own.density);
  EXPECT_EQ(read.youngs_modulus, own.youngs_modulus);
  EXPECT_EQ(read.poisson_ratio, own.poisson_ratio);
  EXPECT_EQ(read.half_width, own.half_width);
  EXPECT_EQ(read.margin, own.margin);
  EXPECT_EQ(read.limit, own.limit);
  EXPECT_EQ(read.time_step, own.time_step);
  EXPECT_EQ(read.n_steps, own.n_steps);
  EXPECT_EQ(read.jitter, own.jitter);
}

TEST(StabilitySection, EntriesAreRead)
{
  const auto read = read_experiment(
      {"Stability/Method=force blend", "Stability/Element size=4", "Stability/Zone half-width=8",
       "Stability/Margin=12", "Stability/Limit=predicted", "Stability/Steps=500",
       "Stability/Clipping=false", "Stability/Calibration iterations=20", "Output/Directory=there",
       "Stability/Quadrature=full", "Stability/Influence function=constant"});
  EXPECT_EQ(read.coupling.method, CouplingMethod::force_blend);
  EXPECT_EQ(read.coupling.points_per_edge, 4);
  EXPECT_EQ(read.half_width, 8);
  EXPECT_EQ(read.margin, 12);
  EXPECT_EQ(read.limit, StepLimit::predicted);
  EXPECT_EQ(read.n_steps, 500);
  EXPECT_FALSE(read.coupling.calibration.clip);
  EXPECT_EQ(read.coupling.calibration.n_iterations, 20);
  EXPECT_EQ(read.directory, "there");
  EXPECT_TRUE(read.full_quadrature);
  EXPECT_EQ(read.influence, InfluenceFunction::constant);
}

TEST(StabilitySection, ImpossibleValuesAreExplained)
{
  expect_refused("Zone half-width=5", {"Stability/Zone half-width = '5'", "Elements of 2 spacings",
                                       "a multiple of 2 from 2 to 40"});
  expect_refused("Margin=42", {"Stability/Margin = '42'", "from 2 to 40"});
  expect_refused("Poisson's ratio=0.5", {"No stable isotropic solid", "between -1 and 0.5"});
  expect_refused("Horizon ratio=9", {"2 to 8 spacings", "3 is usual"});
  expect_refused("Steps=99", {"100 to 1000000 steps", "2000 is usual"});
  expect_refused("Jitter=0.31", {"Points would pass each other", "at most 0.3"});
  expect_refused("Blend width=11", {"at most 10 horizons wide", "2 is usual"});
  expect_refused("Limit=guessed", {"'guessed'", "measured or predicted"});
}

TEST(StabilitySection, UsedParametersGiveTheSameExperiment)
{
  std::ostringstream used;
  write_used_parameters(experiment_with({"Stability/Jitter=0.2", "Stability/Time step=0.8"}), used);
  const auto read = read_stability(ParameterFile::from_text(used.str(), "used.prm"));
  EXPECT_EQ(read.title, "noise");
  EXPECT_EQ(read.directory, "output/noise");
  EXPECT_EQ(read.jitter, 0.2);
  EXPECT_EQ(read.time_step, 0.8);
}

TEST(StabilitySection, ExperimentIsNotAScene)
{
  EXPECT_TRUE(is_stability_file(experiment_with({})));
  EXPECT_FALSE(is_stability_file(scene_with({})));
  expect_error([] { read_scene(experiment_with({})); }, {"noise.prm:1", "'ricochet run'"});
}
} // namespace
} // namespace ricochet::tests
