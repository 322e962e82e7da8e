// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/stability_reader.h"

#include "coupling_reader.h"
#include "parameters.h"
#include "text_tools.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace ricochet
{
namespace
{
constexpr const char *section = "Stability";

/// Lengths in spacings that cells of `edge` points must fill.
int filled_length(const Parameters &parameters, const std::string &name, const int edge,
                  const int largest)
{
  const double value = parameters.quantity(section, name);
  const int number   = static_cast<int>(std::lround(value));
  const int smallest = std::max(2, edge);
  if (number != value || number % edge != 0 || number < smallest || number > largest)
    parameters.fail(section, name,
                    "Elements of " + std::to_string(edge) +
                        " spacings must fill it ('Element size').",
                    "Choose a multiple of " + std::to_string(edge) + " from " +
                        std::to_string(smallest) + " to " + std::to_string(largest) + ".");
  return number;
}
} // namespace

bool is_stability_file(const ParameterFile &file)
{
  const auto &sections = file.sections();
  return std::any_of(sections.begin(), sections.end(),
                     [](const auto &present)
                     { return present.in_file && present.name == section; });
}

StabilityParameters read_stability(const ParameterFile &file)
{
  const Parameters parameters(
      file, stability_declarations(std::filesystem::path(file.path()).stem().string()));
  const auto number = [&](const std::string &name) { return parameters.quantity(section, name); };

  StabilityParameters result;
  result.title                   = parameters.text("", "Title");
  result.directory               = parameters.text("Output", "Directory");
  result.coupling                = read_coupling(parameters, section);
  auto &coupling                 = result.coupling;
  coupling.calibration.clip      = parameters.flag(section, "Clipping");
  coupling.calibration.tolerance = number("Calibration tolerance");
  coupling.calibration.n_iterations =
      static_cast<int>(std::lround(number("Calibration iterations")));
  result.full_quadrature       = parameters.text(section, "Quadrature") == "full";
  result.hourglass_coefficient = number("Hourglass coefficient");

  result.spacing       = number("Grid spacing");
  result.horizon_ratio = number("Horizon ratio");
  for (const auto &function : influence_functions)
    if (function.name == parameters.text(section, "Influence function"))
      result.influence = function.function;
  result.density        = number("Density");
  result.youngs_modulus = number("Young's modulus");
  result.poisson_ratio  = number("Poisson's ratio");
  result.half_width = filled_length(parameters, "Zone half-width", coupling.points_per_edge, 40);
  result.margin     = filled_length(parameters, "Margin", coupling.points_per_edge, 40);

  result.limit =
      parameters.text(section, "Limit") == "predicted" ? StepLimit::predicted : StepLimit::measured;
  result.time_step = number("Time step");
  result.n_steps   = static_cast<int>(std::lround(number("Steps")));
  result.jitter    = number("Jitter");

  if (!(result.poisson_ratio > -1. && result.poisson_ratio < 0.5))
    parameters.fail(section, "Poisson's ratio",
                    "No stable isotropic solid has this Poisson's ratio.",
                    "Choose a value between -1 and 0.5, both excluded.");
  if (result.horizon_ratio < 2. || result.horizon_ratio > 8.)
    parameters.fail(section, "Horizon ratio", "The horizon has 2 to 8 spacings.",
                    "Choose such a number; 3 is usual.");
  if (result.n_steps < 100 || result.n_steps > 1000000)
    parameters.fail(section, "Steps", "Growth shows in 100 to 1000000 steps.",
                    "Choose such a number; 2000 is usual.");
  if (result.jitter > 0.3)
    parameters.fail(section, "Jitter", "Points would pass each other.",
                    "Choose at most 0.3 spacings.");
  return result;
}
} // namespace ricochet
