// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/interface_report.h"

#include "support/coupled_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
/// Where the projectile and the energies are after some steps.
std::vector<double> after_steps(Simulation &simulation)
{
  for (int i = 0; i < 20; ++i)
  {
    simulation.compute_forces(false);
    simulation.advance();
  }
  simulation.compute_forces(true);
  const auto energies = simulation.energies();
  const auto &motion  = simulation.projectile().motion();
  return {motion.position.x(), motion.position.z(), motion.velocity.x(),
          motion.velocity.z(), energies.strain,     energies.kinetic};
}

TEST(InterfaceReport, LeavesTheSimulationAsItWas)
{
  Simulation untouched(MPI_COMM_WORLD, coupled_scene());
  Simulation tested(MPI_COMM_WORLD, coupled_scene());
  const auto reports = interface_reports(MPI_COMM_WORLD, tested);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].plate, 0u);
  EXPECT_TRUE(reports[0].step_good());
  EXPECT_GT(reports[0].share_of_volume, 0.);
  EXPECT_LT(reports[0].share_of_volume, 1.);
  EXPECT_GT(reports[0].patch.n_strains, 0);
  EXPECT_EQ(after_steps(tested), after_steps(untouched));
}

TEST(InterfaceReport, OfPlatesWithoutElementsIsNone)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  EXPECT_TRUE(interface_reports(MPI_COMM_WORLD, simulation).empty());
}

TEST(InterfaceReport, IsGoodIfAllLimitsAreKept)
{
  InterfaceReport report{};
  report.patch.converged = true;
  report.step_limit      = 2e-7;
  report.time_step       = 1e-7;
  EXPECT_TRUE(report.good());
  report.patch.ghost_force = 1.01 * InterfaceReport::most_ghost_force;
  EXPECT_FALSE(report.good());
  report.patch              = {};
  report.patch.converged    = true;
  report.patch.strain_error = 1.01 * InterfaceReport::most_strain_error;
  EXPECT_FALSE(report.good());
  report.patch = {};
  EXPECT_FALSE(report.good()) << "not converged";
  report.patch.converged = true;
  report.time_step       = report.step_limit;
  EXPECT_FALSE(report.good());
}
} // namespace
} // namespace ricochet::tests
