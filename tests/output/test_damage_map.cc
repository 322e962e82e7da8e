// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/damage_map.h"

#include "support/scratch_directory.h"

namespace ricochet
{
namespace
{
using namespace tests;

TEST(DamageMap, HasARowPerXAndTellsWhereItLies)
{
  const ScratchDirectory scratch;
  DamageMap map{2, 3, 2, 0.5e-3, {-1e-3, 2e-3}, true, {}, {}, {}};
  for (int i = 0; i < 6; ++i)
  {
    map.front.push_back(0.125F * i);
    map.rear.push_back(0.F);
    map.mean.push_back(1.F);
  }
  write_damage_maps(MPI_COMM_WORLD, scratch.path(), {map});
  if (rank() != 0)
    return;
  const auto file    = scratch.path() / "damage.h5";
  const Dataset grid = read_dataset(file, "plate_2_grid");
  EXPECT_EQ(grid.values, (std::vector<double>{0.5e-3, -1e-3, 2e-3, 1.}));
  EXPECT_EQ(grid.unit, "m");
  const Dataset front = read_dataset(file, "plate_2_front");
  EXPECT_EQ(front.shape, (std::vector<hsize_t>{3, 2}));
  EXPECT_EQ(front.values, (std::vector<double>{0., 0.125, 0.25, 0.375, 0.5, 0.625}));
}

TEST(DamageMap, OfNoPlatesIsAnEmptyFile)
{
  const ScratchDirectory scratch;
  write_damage_maps(MPI_COMM_WORLD, scratch.path(), {});
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "damage.h5"));
}
} // namespace
} // namespace ricochet
