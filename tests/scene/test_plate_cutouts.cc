// SPDX-License-Identifier: LGPL-2.1-or-later
// 'Hole', 'Notch', 'Crack across' and 'Crack along' of a plate of 200 x 100 x 30 mm.
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
TEST(PlateCutoutEntries, AreRead)
{
  const auto cutouts = read_with({"Symmetric=false", "Plate 1/Hole=60 mm, 1 mm, 12 mm",
                                  "Plate 1/Hole 2=90 mm, 0 mm, 1 cm",
                                  "Plate 1/Notch 2=10 mm, 12 mm, -20 mm, 30 mm, 0 mm, 5 mm",
                                  "Plate 1/Crack across=70 mm, -9 mm, 8 mm, 1 mm, 10 mm",
                                  "Plate 1/Crack along 2=7 mm, 80 mm, 120 mm, 0 mm, 30 mm"})
                           .plates[0]
                           .cutouts;
  ASSERT_EQ(cutouts.holes.size(), 2u);
  EXPECT_DOUBLE_EQ(cutouts.holes[0].x, 60e-3);
  EXPECT_DOUBLE_EQ(cutouts.holes[0].y, 1e-3);
  EXPECT_DOUBLE_EQ(cutouts.holes[0].diameter, 12e-3);
  EXPECT_DOUBLE_EQ(cutouts.holes[1].x, 90e-3);
  ASSERT_EQ(cutouts.notches.size(), 1u);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].x_from, 10e-3);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].x_to, 12e-3);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].y_from, -20e-3);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].y_to, 30e-3);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].depth_from, 0.);
  EXPECT_DOUBLE_EQ(cutouts.notches[0].depth_to, 5e-3);
  ASSERT_EQ(cutouts.cracks.size(), 2u);
  EXPECT_EQ(cutouts.cracks[0].normal, 0);
  EXPECT_DOUBLE_EQ(cutouts.cracks[0].at, 70e-3);
  EXPECT_DOUBLE_EQ(cutouts.cracks[0].from, -9e-3);
  EXPECT_DOUBLE_EQ(cutouts.cracks[0].to, 8e-3);
  EXPECT_DOUBLE_EQ(cutouts.cracks[0].depth_from, 1e-3);
  EXPECT_DOUBLE_EQ(cutouts.cracks[0].depth_to, 10e-3);
  EXPECT_EQ(cutouts.cracks[1].normal, 1);
  EXPECT_DOUBLE_EQ(cutouts.cracks[1].at, 7e-3);
  EXPECT_DOUBLE_EQ(cutouts.cracks[1].from, 80e-3);
  EXPECT_TRUE(read_with({}).plates[0].cutouts.empty());
}

TEST(PlateCutoutEntries, MustLieInThePlateAndHaveAnExtent)
{
  expect_scene_error({"Plate 1/Hole=60 mm, 0 mm, 0 mm"}, {"Plate 1/Hole", "diameter", "above 0"});
  expect_scene_error({"Plate 1/Hole=210 mm, 0 mm, 12 mm"},
                     {"Plate 1/Hole", "misses the plate", "200 mm", "50 mm"});
  expect_scene_error({"Plate 1/Notch=10 mm, 12 mm, -5 mm, 5 mm, -5 mm, 0 mm"},
                     {"Plate 1/Notch", "misses the plate", "depth", "upper face", "30 mm"});
  expect_scene_error({"Plate 1/Notch=12 mm, 10 mm, -5 mm, 5 mm, 0 mm, 5 mm"},
                     {"Plate 1/Notch", "empty", "12 mm is not below 10 mm"});
  expect_scene_error({"Plate 1/Crack across=0 mm, -5 mm, 5 mm, 0 mm, 5 mm"},
                     {"Plate 1/Crack across", "misses the plate"});
  expect_scene_error({"Plate 1/Crack across=10 mm, -5 mm, 5 mm, 5 mm, 5 mm"},
                     {"Plate 1/Crack across", "empty"});
  expect_scene_error({"Plate 1/Crack along=0 mm, 250 mm, 300 mm, 0 mm, 5 mm"},
                     {"Plate 1/Crack along", "misses the plate"});
  // Over an edge it may reach.
  EXPECT_EQ(read_with({"Plate 1/Hole=205 mm, 0 mm, 12 mm"}).plates[0].cutouts.holes.size(), 1u);
}

TEST(PlateCutoutEntries, AreTheirOwnMirrorImagesInASymmetricScene)
{
  for (const auto &[name, value] :
       {std::pair<std::string, std::string>{"Hole", "60 mm, 1 mm, 12 mm"},
        {"Notch", "10 mm, 12 mm, 0 mm, 5 mm, 0 mm, 5 mm"},
        {"Crack across", "10 mm, 0 mm, 5 mm, 0 mm, 5 mm"},
        {"Crack along", "5 mm, 10 mm, 50 mm, 0 mm, 5 mm"}})
  {
    const std::string given = "Plate 1/" + name + "=" + value;
    expect_scene_error({given}, {"Plate 1/" + name, "mirror image", "y = 0", "Symmetric = false"});
    EXPECT_FALSE(read_with({given, "Symmetric=false"}).plates[0].cutouts.empty());
  }
}

TEST(PlateCutoutEntries, NeedPoints)
{
  expect_scene_error({"Coupling/Zone=none", "Plate 1/Hole=60 mm, 0 mm, 12 mm"},
                     {"Plate 1/Hole", "Finite elements alone", "Zone"});
}
} // namespace
} // namespace ricochet::tests
