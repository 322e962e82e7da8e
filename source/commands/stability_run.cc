// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stability_run.h"

#include "result_folder.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"
#include "ricochet/base/version.h"
#include "ricochet/output/summary.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/simulation/stability_experiment.h"

#include <nlohmann/json.hpp>

#include <chrono>

namespace ricochet
{
const std::vector<std::string> stability_columns{
    "verdict",      "reason",       "growth_per_step",         "growth_per_us",
    "energy_drift", "strain_error", "step_over_measured_limit"};

namespace
{
const char *method_name(const CouplingMethod method)
{
  for (const auto &entry : coupling_methods)
    if (entry.method == method)
      return entry.name;
  return "";
}

nlohmann::ordered_json summary_of(const StabilityParameters &parameters,
                                  const StabilityResult &result, const double wall_seconds)
{
  return {{"title", parameters.title},
          {"method", method_name(parameters.coupling.method)},
          {"verdict", verdict_name(result.verdict)},
          {"reason", result.reason},
          {"growth_per_step", result.growth_per_step},
          {"growth_per_us", result.growth_per_us},
          {"growth", result.growth},
          {"ran_away", result.ran_away},
          {"steps", result.n_steps},
          {"time_step_us", result.time_step / units::us},
          {"step_over_measured_limit", result.time_step / result.measured_step},
          {"predicted_over_measured_limit", result.predicted_step / result.measured_step},
          {"energy_drift", result.energy_drift},
          {"hourglass_growth", result.hourglass_growth},
          {"ghost_force", result.patch.ghost_force},
          {"strain_error", result.patch.strain_error},
          {"smallest_eigenvalue", result.smallest_eigenvalue},
          {"free_points", result.n_points},
          {"elements", result.n_elements},
          {"wall_seconds", wall_seconds},
          {"failed", false},
          {"interrupted", false},
          {"version", version()}};
}
} // namespace

std::vector<std::string> stability_fields()
{
  std::vector<std::string> names;
  const auto summary = summary_of({}, {}, 0.);
  for (const auto &[name, value] : summary.items())
    names.push_back(name);
  return names;
}

nlohmann::ordered_json run_stability(const MPI_Comm communicator, const ParameterFile &file,
                                     const RunOptions &options)
{
  const auto start                      = std::chrono::steady_clock::now();
  const StabilityParameters parameters  = read_stability(file);
  const std::filesystem::path directory = parameters.directory;
  prepare_result_folder(communicator, directory, file, options.force);

  const auto result = run_stability_experiment(communicator, parameters);
  auto summary =
      summary_of(parameters, result,
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  write_summary(communicator, directory, summary);
  return summary;
}

std::string describe_stability(const nlohmann::ordered_json &summary)
{
  const auto text   = [&](const char *key) { return summary[key].get<std::string>(); };
  const auto number = [&](const char *key, const int n_digits, const double factor = 1.)
  { return with_digits(factor * summary[key].get<double>(), n_digits); };
  const auto reason = text("reason");
  return text("verdict") + (reason.empty() ? "" : ": ") + reason + ". Kinetic energy grows by " +
         number("growth_per_step", 3) + " per step (" + number("growth_per_us", 3) +
         " per us); discrete energy drifts by " + number("energy_drift", 2) + "; strain error " +
         number("strain_error", 2, 100.) + " %, ghost force " + number("ghost_force", 2) +
         " M eps h^2; the step is " +
         with_decimals(summary["step_over_measured_limit"].get<double>(), 3) +
         " of the largest stable one.";
}
} // namespace ricochet
