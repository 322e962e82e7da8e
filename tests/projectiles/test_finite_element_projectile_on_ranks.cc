// SPDX-License-Identifier: LGPL-2.1-or-later
// A deformable projectile on one rank and on all: exactly the same numbers.
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
std::vector<double> history(const MPI_Comm communicator, const Scene &scene)
{
  Simulation simulation(communicator, scene);
  std::vector<double> rows{simulation.dt()};
  const auto add = [&](const Vector3 &v) { rows.insert(rows.end(), v.data(), v.data() + 3); };
  for (int i = 0; i <= 160; ++i)
  {
    simulation.compute_forces(/*energy=*/i % 20 == 0);
    if (i % 20 == 0)
    {
      const auto &motion = simulation.projectile().motion();
      for (const auto &v : {motion.position, motion.velocity, motion.spin,
                            simulation.reaction().normal, simulation.reaction().friction,
                            simulation.reaction().shank, simulation.reaction().moment})
        add(v);
      const auto e = simulation.energies();
      rows.insert(rows.end(), {e.projectile, e.elastic, e.kinetic, e.strain, e.contact, e.debris,
                               e.friction, e.fracture, simulation.broken_bonds()});
    }
    simulation.advance();
  }
  return rows;
}

TEST(RankIndependence, DeformableProjectileIsExactlyTheSame)
{
  for (const auto &scene :
       {deformable(small_scene()), deformable(symmetric(two_plates())), modal(small_scene()),
        modal(symmetric(two_plates())), peridynamic(symmetric(small_scene())),
        peridynamic_nose(symmetric(small_scene()))})
  {
    std::vector<double> all = history(MPI_COMM_WORLD, scene), one(all.size());
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0)
      one = history(MPI_COMM_SELF, scene);
    MPI_Bcast(one.data(), static_cast<int>(one.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
    int n_different = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      n_different += all[i] != one[i];
    EXPECT_EQ(n_different, 0) << "of " << all.size();
    EXPECT_GT(all.back(), 500.) << "too few broken bonds for a hard test";
  }
}
} // namespace
} // namespace ricochet::tests
