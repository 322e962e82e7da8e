// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/plate_size.h"

#include "ricochet/base/exceptions.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
Scene big_plate()
{
  Scene scene               = small_scene();
  scene.plates[0].length    = 0.2;
  scene.plates[0].width     = 0.1;
  scene.plates[0].thickness = 0.03;
  scene.plates[0].spacing   = 1.5e-3;
  scene.impact.entry_x      = 0.05;
  return scene;
}

using Points = std::array<int, 3>;

TEST(PlateSize, LatticeOfAPeridynamicPlateIsRoundedToPoints)
{
  Scene scene = big_plate();
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{133, 67, 20}));
  scene.symmetric = true;
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{133, 33, 20}));
}

TEST(PlateSize, LatticeWithElementsIsAMultipleOfTheLargest)
{
  Scene scene                  = big_plate();
  scene.zone.kind              = ZoneKind::automatic;
  scene.zone.coarsening_levels = 0; // cubes of 2 points
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{134, 66, 20}));
  scene.zone.coarsening_levels = 1; // of 4
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{132, 68, 20}));
  // 20 points are 10 cells through the thickness: cubes can double once.
  scene.zone.coarsening_levels = -1;
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{132, 68, 20}));
  scene.plates[0].thickness = 24e-3; // 8 cells: twice, and not more
  EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{136, 64, 16}));
  scene.plates[0].thickness = 27e-3; // 9 cells: never
  EXPECT_EQ(lattice_points(scene, scene.plates[0])[2], 18);
}

TEST(PlateSize, ElementsOfOtherSizesDoubleUntilTheyHoldEightPoints)
{
  Scene scene               = big_plate();
  scene.zone.kind           = ZoneKind::automatic;
  scene.plates[0].thickness = 24e-3; // 16 points
  for (const int n : {1, 2, 4})
  {
    scene.zone.coupling.points_per_edge = n;
    EXPECT_EQ(lattice_points(scene, scene.plates[0]), (Points{136, 64, 16})) << n;
  }
  scene.plates[0].thickness = 27e-3; // 18 points
  try
  {
    lattice_points(scene, scene.plates[0]);
    FAIL() << "a plate of 30 mm instead of 27";
  }
  catch (const InputError &error)
  {
    for (const char *part : {"27 mm", "30 mm", "6 mm", "Element size"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(PlateSize, RoundingThatMakesAnotherPlateIsRefused)
{
  Scene scene                  = big_plate();
  scene.zone.kind              = ZoneKind::automatic;
  scene.zone.coarsening_levels = 2; // cubes of 12 mm would make 36 mm of 30
  try
  {
    lattice_points(scene, scene.plates[0]);
    FAIL() << "a plate of 36 mm instead of 30";
  }
  catch (const InputError &error)
  {
    for (const char *part : {"thickness", "30 mm", "36 mm", "12 mm", "5 %", "Coarsening levels"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  scene.zone.kind = ZoneKind::everything; // nothing to fill
  EXPECT_EQ(lattice_points(scene, scene.plates[0])[2], 20);
  // Points alone may be too few, too.
  scene.plates[0].thickness = 10.6e-3; // 7.07 spacings
  EXPECT_EQ(lattice_points(scene, scene.plates[0])[2], 7);
  scene.plates[0].thickness = 11.2e-3; // 7.47
  try
  {
    lattice_points(scene, scene.plates[0]);
    FAIL() << "a plate of 10.5 mm instead of 11.2";
  }
  catch (const InputError &error)
  {
    for (const char *part : {"thickness", "11.2 mm", "10.5 mm", "points 1.5 mm apart", "5 %",
                             "multiple of 1.5 mm", "Grid spacing"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("Coupling"), std::string::npos) << error.what();
  }
}

TEST(PlateSize, IsThatOfTheWholePlateAsAskedAndAsComputed)
{
  Scene scene = two_plates(); // of whole millimetres, which are points
  for (const bool half : {false, true})
  {
    scene.symmetric  = half;
    const auto sizes = plate_sizes(scene);
    ASSERT_EQ(sizes.size(), 2u);
    for (const auto &size : sizes)
    {
      EXPECT_EQ(size_text(size.asked), "30 x 16 x 4 mm");
      EXPECT_EQ(size_text(size.computed), "30 x 16 x 4 mm");
      EXPECT_TRUE(size.is_as_asked());
    }
  }
  scene           = big_plate();
  scene.symmetric = true; // 133 x 2 * 33 x 20 points
  EXPECT_EQ(size_text(plate_sizes(scene)[0].asked), "200 x 100 x 30 mm");
  EXPECT_EQ(size_text(plate_sizes(scene)[0].computed), "199.5 x 99 x 30 mm");
  EXPECT_FALSE(plate_sizes(scene)[0].is_as_asked());
  scene.symmetric = false; // 67 points across
  EXPECT_EQ(size_text(plate_sizes(scene)[0].computed), "199.5 x 100.5 x 30 mm");
}

TEST(PlateSize, IsThatOfTheLattice)
{
  Scene scene            = symmetric(small_scene());
  scene.plates[0].length = 30.3e-3;
  scene.plates[0].width  = 16.6e-3;
  const auto size        = plate_sizes(scene)[0].computed;
  const auto [low, high] = Simulation(MPI_COMM_SELF, scene).target_box();
  EXPECT_LT((high - low - size).norm(), 1e-15);
}
} // namespace
} // namespace ricochet::tests
