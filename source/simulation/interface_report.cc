// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/interface_report.h"

#include "ricochet/base/units.h"
#include "ricochet/coupling/dispersion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace ricochet
{
namespace
{
double seconds_of_points(PeridynamicBody &points)
{
  constexpr int n_repeats = 10;
  const auto start        = std::chrono::steady_clock::now();
  for (int i = 0; i < n_repeats; ++i)
    points.compute_internal_forces({/*energy=*/false, /*is_step=*/false});
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
         n_repeats;
}

const char *verdict(const bool good)
{
  return good ? "ok" : "FAILS";
}
} // namespace

std::vector<InterfaceReport> interface_reports(const MPI_Comm communicator, Simulation &simulation,
                                               const double residual_left)
{
  std::vector<InterfaceReport> reports;
  for (std::size_t i = 0; i < simulation.n_plates(); ++i)
  {
    auto *const far = simulation.coupled_plate(i);
    if (!far || far->zone().n_slaved_cells() == 0)
      continue;
    InterfaceReport report{};
    report.plate           = i;
    report.patch           = patch_test(communicator, *far, /*most_iterations=*/200, residual_left);
    const auto &estimate   = simulation.frequencies()[i];
    report.frequency       = std::sqrt(estimate.squared_frequency);
    report.step_limit      = 2. / report.frequency;
    report.predicted_limit = predicted_time_step(far->points(), &far->options()).step();
    report.time_step       = simulation.dt();
    report.share_of_volume =
        double(far->zone().n_free_cells()) / static_cast<double>(far->zone().n_cells_in_all());
    report.seconds_per_force = estimate.seconds_per_force;
    report.seconds_of_points = seconds_of_points(far->points());
    far->rest();
    reports.push_back(report);
  }
  return reports;
}

void print(const std::vector<InterfaceReport> &reports)
{
  using namespace units;
  if (reports.empty())
    std::printf("interface      none: no plate has both points and elements\n");
  for (const auto &r : reports)
  {
    std::printf("interface      plate %zu\n", r.plate + 1);
    std::printf("  ghost force  %.2e of strain (K + 4 mu/3) h^2, %d strains; limit %.0e   %s\n",
                r.patch.ghost_force, r.patch.n_strains, InterfaceReport::most_ghost_force,
                verdict(r.ghost_good()));
    std::printf("  strain error %.3f %% after relaxation (%d iterations); limit %.1f %%   %s\n",
                100. * r.patch.strain_error, r.patch.n_iterations,
                100. * InterfaceReport::most_strain_error, verdict(r.strain_good()));
    std::printf("  frequency    %.4g rad/us; step limit %.4g us (predicted %.4g us), step of the "
                "run %.4g us (contact "
                "included)   %s\n",
                1e-6 * r.frequency, r.step_limit / us, r.predicted_limit / us, r.time_step / us,
                verdict(r.step_good()));
    std::printf(
        "  share        %.1f %% of the volume is peridynamic and takes %.0f %% of the force "
        "evaluation\n",
        100. * r.share_of_volume, 100. * r.share_of_cost());
  }
}
} // namespace ricochet
