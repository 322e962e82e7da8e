// SPDX-License-Identifier: LGPL-2.1-or-later
// What a simulation reports of contact has the units that contact/contact_record.h states.
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(ContactRecordInRuns, DepthsAreInMetresAndInSpacingsAsTheirNamesSay)
{
  Simulation simulation(MPI_COMM_SELF, small_scene());
  const double spacing = small_scene().plates[0].spacing;
  ASSERT_LT(spacing, 0.1) << "or metres could be taken for spacings";
  double deepest = 0.;
  for (int step = 0; step < 40; ++step)
  {
    simulation.compute_forces(/*energy=*/false);
    const auto &record = simulation.reaction();
    EXPECT_DOUBLE_EQ(record.deepest_in_spacings, record.deepest / spacing);
    deepest = std::max(deepest, record.deepest);
    simulation.advance();
  }
  EXPECT_GT(deepest, 0.) << "they must have met";
  EXPECT_LT(deepest, 5. * spacing);
}
} // namespace
} // namespace ricochet::tests
