// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_sections.h"
#include "sections.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
const Words<StepLimit> step_limits{{StepLimit::measured, "measured"},
                                   {StepLimit::predicted, "predicted"}};

/// The rows that checks speak of, and whole numbers before it is known that they are.
struct StabilityEntries
{
  StabilityParameters &experiment;
  double n_iterations = 0., n_steps = 0., half_width = 0., margin = 0.;
  const Entry *poisson_ratio = nullptr, *horizon = nullptr, *steps = nullptr, *jitter = nullptr,
              *zone = nullptr, *around = nullptr;

  void take_whole_numbers() const;
  void check() const;
};

/// Lengths in spacings that cells of `edge` points must fill.
int filled_length(const Entry &entry, const double value, const int edge)
{
  constexpr int largest = 40;
  const int number      = static_cast<int>(std::lround(value));
  const int smallest    = std::max(2, edge);
  if (number != value || number % edge != 0 || number < smallest || number > largest)
    entry.fail("Elements of " + std::to_string(edge) + " spacings must fill it ('Element size').",
               "Choose a multiple of " + std::to_string(edge) + " from " +
                   std::to_string(smallest) + " to " + std::to_string(largest) + ".");
  return number;
}

void StabilityEntries::take_whole_numbers() const
{
  auto &coupling                    = experiment.coupling;
  coupling.calibration.n_iterations = static_cast<int>(std::lround(n_iterations));
  experiment.n_steps                = static_cast<int>(std::lround(n_steps));
  experiment.half_width             = filled_length(*zone, half_width, coupling.points_per_edge);
  experiment.margin                 = filled_length(*around, margin, coupling.points_per_edge);
}

void StabilityEntries::check() const
{
  check_poissons_ratio(*poisson_ratio, experiment.poisson_ratio);
  if (experiment.horizon_ratio < 2. || experiment.horizon_ratio > 8.)
    horizon->fail("The horizon has 2 to 8 spacings.", "Choose such a number; 3 is usual.");
  if (experiment.n_steps < 100 || experiment.n_steps > 1000000)
    steps->fail("Growth shows in 100 to 1000000 steps.", "Choose such a number; 2000 is usual.");
  if (experiment.jitter > 0.3)
    jitter->fail("Points would pass each other.", "Choose at most 0.3 spacings.");
}

void add_calibration_entries(Section &in, StabilityEntries &rows)
{
  auto &calibration = rows.experiment.coupling.calibration;
  in.with_default("Calibration tolerance",
                  quantity(calibration.tolerance, Dimension::number, Limit::positive), "0.0002",
                  "Largest nodal force left under a unit strain, in units of M h^2");
  in.with_default("Calibration iterations",
                  quantity(rows.n_iterations, Dimension::number, Limit::not_negative), "300",
                  "Steps of conjugate gradients, at most");
  in.with_default("Clipping", flag(calibration.clip), "true",
                  "Whether negative eigenvalues of calibrated tensors are raised to zero");
}

void add_body_entries(Section &in, StabilityEntries &rows)
{
  auto &experiment = rows.experiment;
  in.with_default("Grid spacing", quantity(experiment.spacing, Dimension::length, Limit::positive),
                  "1 mm", "Distance between neighbouring points");
  rows.horizon = &in.with_default(
      "Horizon ratio", quantity(experiment.horizon_ratio, Dimension::number, Limit::positive), "3",
      "Horizon in grid spacings, at least 2");
  in.with_default("Influence function", choice(experiment.influence, influence_function_words()),
                  "cone", "Weight of a bond over its length");
  in.with_default("Density", quantity(experiment.density, Dimension::density, Limit::positive),
                  "1190 kg/m3", "Mass per volume");
  in.with_default("Young's modulus",
                  quantity(experiment.youngs_modulus, Dimension::stress, Limit::positive), "6 GPa",
                  "Young's modulus");
  rows.poisson_ratio = &in.with_default(
      "Poisson's ratio", quantity(experiment.poisson_ratio, Dimension::number, Limit::any), "0.35",
      "Poisson's ratio between -1 and 0.5");
  rows.zone = &in.with_default("Zone half-width",
                               quantity(rows.half_width, Dimension::number, Limit::positive), "4",
                               "Half the edge of the block of free points, in spacings");
  rows.around =
      &in.with_default("Margin", quantity(rows.margin, Dimension::number, Limit::positive), "4",
                       "Elements around all points, in spacings");
}

void add_step_entries(Section &in, StabilityEntries &rows)
{
  auto &experiment = rows.experiment;
  in.with_default("Limit", choice(experiment.limit, step_limits), "measured",
                  "Largest stable step: measured by power iteration of the body, or predicted from "
                  "plane waves in lattice and elements");
  in.with_default("Time step", quantity(experiment.time_step, Dimension::number, Limit::positive),
                  "0.9", "Time step in units of the limit");
  rows.steps = &in.with_default("Steps", quantity(rows.n_steps, Dimension::number, Limit::positive),
                                "2000", "Number of time steps");
  rows.jitter = &in.with_default(
      "Jitter", quantity(experiment.jitter, Dimension::number, Limit::not_negative), "0",
      "Random displacement of all points and nodes at the start, in spacings");
}

Section stability_section(StabilityParameters &experiment)
{
  Section in(stability_name,
             "A stability experiment instead of an impact: a block of points in a box of elements, "
             "released from noise and left alone.");
  const auto rows = std::make_shared<StabilityEntries>(StabilityEntries{experiment});
  add_interface_entries(in, experiment.coupling, experiment.full_quadrature,
                        experiment.hourglass_coefficient);
  add_calibration_entries(in, *rows);
  add_body_entries(in, *rows);
  add_step_entries(in, *rows);
  in.check(
      [rows]
      {
        rows->take_whole_numbers();
        rows->check();
      });
  return in;
}
} // namespace

std::vector<Section> stability_sections(const std::string &stem, StabilityParameters &experiment)
{
  Section top("", "");
  top.named_after_file("Title", text(experiment.title, "any text"), stem, "A stability experiment",
                       "What the experiment is called in its results, by default like the file");
  Section output("Output", "Where the results go.");
  output.named_after_file(
      "Directory", text(experiment.directory, "a folder, relative to where the program is started"),
      "output/" + stem, "output/stability",
      "Where the results go, by default output/ and the file's name");

  std::vector<Section> sections;
  sections.push_back(std::move(top));
  sections.push_back(stability_section(experiment));
  sections.push_back(std::move(output));
  return sections;
}
} // namespace ricochet
