// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/interface_report.h"

#include "ricochet/base/phase_clock.h"

#include "ricochet/coupling/dispersion.h"

#include <cassert>
#include <chrono>
#include <cmath>

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
} // namespace

std::vector<InterfaceReport> interface_reports(const MPI_Comm communicator, Simulation &simulation,
                                               const double residual_left)
{
  const PhaseClock::Work work(Phase::set_up);
  assert(simulation.step() == 0);
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
} // namespace ricochet
