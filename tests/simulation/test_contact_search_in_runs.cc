// SPDX-License-Identifier: LGPL-2.1-or-later
// A run is the same to the last bit with every method of contact search.
#include "ricochet/contact/contact_search.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(ContactSearchInRuns, DoNotDependOnTheMethod)
{
  for (const auto &scene : {symmetric(small_scene()), two_plates()})
  {
    std::vector<std::vector<double>> ends;
    for (const auto &search : contact_search_names())
    {
      Scene variant          = scene;
      variant.contact.search = search;
      Simulation simulation(MPI_COMM_WORLD, variant);
      for (int step = 0; step < 100; ++step)
      {
        simulation.compute_forces(/*energy=*/step == 99);
        if (step < 99)
          simulation.advance();
      }
      const auto &motion = simulation.projectile().motion();
      const auto e       = simulation.energies();
      ends.push_back({motion.position.x(), motion.velocity.x(), motion.velocity.z(),
                      motion.spin.y(), e.kinetic, e.strain, e.debris, simulation.broken_bonds()});
    }
    for (const auto &end : ends)
      EXPECT_EQ(end, ends[0]); // not nearly: exactly
    EXPECT_GT(ends[0][6], 0.) << "there must be debris in contact";
  }
}
} // namespace
} // namespace ricochet::tests
