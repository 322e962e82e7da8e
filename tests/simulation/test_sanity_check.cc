// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/sanity_check.h"

#include "ricochet/base/exceptions.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(SanityCheck, EnergyThatGrowsByMoreThanAQuarterIsARunaway)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  simulation.compute_forces(true);
  Totals totals = totals_of(simulation);
  EXPECT_NO_THROW(check_energy({simulation, totals}));
  totals.energies.strain += 0.24 * totals.energies.initial;
  EXPECT_NO_THROW(check_energy({simulation, totals}));
  totals.energies.strain += 0.02 * totals.energies.initial;
  try
  {
    check_energy({simulation, totals});
    FAIL() << "nothing was thrown";
  }
  catch (const RunError &error)
  {
    const std::string message = error.what();
    for (const char *part : {"runs away", "126", "fastest", "Time/Safety factor"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(SanityCheck, EnergyThatIsLostIsNone)
{
  Simulation simulation(MPI_COMM_WORLD, two_plates());
  simulation.compute_forces(true);
  Totals totals = totals_of(simulation);
  totals.energies.projectile -= 0.9 * totals.energies.initial;
  EXPECT_NO_THROW(check_energy({simulation, totals}));
}
} // namespace
} // namespace ricochet::tests
