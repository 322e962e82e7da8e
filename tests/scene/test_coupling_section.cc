// SPDX-License-Identifier: LGPL-2.1-or-later
// The section 'Coupling' and the zone boxes of plates.
#include "support/scene_text.h"

#include <cmath>

namespace ricochet::tests
{
namespace
{
TEST(CouplingSection, DefaultsArePeridynamicsThroughout)
{
  const auto zone = read_with({}).zone;
  EXPECT_EQ(zone.kind, ZoneKind::everything);
  EXPECT_FALSE(zone.has_elements());
  EXPECT_FALSE(zone.adaptive);
  EXPECT_FALSE(zone.grows_everywhere);
  EXPECT_EQ(zone.conversion_stretch, 0.5);
  EXPECT_EQ(zone.coupling.method, CouplingMethod::calibrated_energy_blend);
  EXPECT_EQ(zone.coupling.blend, BlendFunction::cubic);
  EXPECT_EQ(zone.coupling.blend_width, 2.);
  EXPECT_TRUE(zone.coupling.correct_mass);
  EXPECT_EQ(zone.coupling.points_per_edge, 2);
  EXPECT_EQ(zone.coarsening_levels, -1);
  EXPECT_FALSE(zone.full_quadrature);
  EXPECT_EQ(zone.hourglass_coefficient, 1.);
}

TEST(CouplingSection, AllEntriesAreRead)
{
  const auto zone = read_with({"Coupling/Zone=automatic", "Coupling/Adaptive=true",
                               "Coupling/Growth=plate", "Coupling/Conversion stretch=0.4",
                               "Coupling/Method=energy blend", "Coupling/Blend function=linear",
                               "Coupling/Blend width=3", "Coupling/Mass correction=false",
                               "Coupling/Coarsening levels=2", "Coupling/Quadrature=full",
                               "Coupling/Hourglass coefficient=0.5", "Coupling/Element size=4"})
                        .zone;
  EXPECT_EQ(zone.kind, ZoneKind::automatic);
  EXPECT_TRUE(zone.has_elements());
  EXPECT_TRUE(zone.adaptive);
  EXPECT_TRUE(zone.grows_everywhere);
  EXPECT_EQ(zone.conversion_stretch, 0.4);
  EXPECT_EQ(zone.coupling.method, CouplingMethod::energy_blend);
  EXPECT_EQ(zone.coupling.blend, BlendFunction::linear);
  EXPECT_EQ(zone.coupling.blend_width, 3.);
  EXPECT_FALSE(zone.coupling.correct_mass);
  EXPECT_EQ(zone.coarsening_levels, 2);
  EXPECT_EQ(zone.coupling.points_per_edge, 4);
  EXPECT_TRUE(zone.full_quadrature);
  EXPECT_EQ(zone.hourglass_coefficient, 0.5);
  EXPECT_FALSE(
      read_with({"Coupling/Zone=automatic", "Coupling/Growth=plate"}).zone.grows_everywhere)
      << "only zones that grow";
}

TEST(CouplingSection, EveryMethodHasItsName)
{
  for (const auto &method : coupling_methods)
    EXPECT_EQ(read_with({"Coupling/Zone=automatic", std::string("Coupling/Method=") + method.name})
                  .zone.coupling.method,
              method.method);
}

TEST(CouplingSection, BoxesAreRead)
{
  const auto scene =
      read_with({"Coupling/Zone=boxes", "Plate 1/Zone box=30 mm, 9 cm, -20 mm, 20 mm",
                 "Plate 1/Zone box 2=90 mm, 120 mm, -10 mm, 10 mm"});
  EXPECT_EQ(scene.zone.kind, ZoneKind::boxes);
  ASSERT_EQ(scene.plates[0].zone_boxes.size(), 2u);
  const std::array<double, 4> first{0.03, 0.09, -0.02, 0.02}, second{0.09, 0.12, -0.01, 0.01};
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_DOUBLE_EQ(scene.plates[0].zone_boxes[0][i], first[i]);
    EXPECT_DOUBLE_EQ(scene.plates[0].zone_boxes[1][i], second[i]);
  }
  EXPECT_EQ(read_with({"Coupling/Zone=none"}).zone.kind, ZoneKind::none);
}

TEST(CouplingSection, BadValuesAreNamedWithTheirPlace)
{
  expect_scene_error({"Coupling/Zone=some"}, {"Coupling", "Zone", "some", "automatic"});
  expect_scene_error({"Coupling/Method=glue"}, {"Coupling", "Method", "glue", "energy blend"});
  expect_scene_error({"Coupling/Adaptive=perhaps"}, {"Coupling", "Adaptive", "perhaps"});
  expect_scene_error({"Coupling/Conversion stretch=1.5"},
                     {"Coupling", "Conversion stretch", "1.5"});
  expect_scene_error({"Coupling/Conversion stretch=-0.1"},
                     {"Coupling", "Conversion stretch", "-0.1"});
  expect_scene_error({"Coupling/Coarsening levels=3"}, {"Coupling", "Coarsening levels", "3"});
  expect_scene_error({"Coupling/Element size=3"}, {"Coupling", "Element size", "3"});
  expect_scene_error({"Coupling/Blend width=0"}, {"Coupling", "Blend width"});
  expect_scene_error({"Coupling/Blend width=11"}, {"Coupling", "Blend width", "10 horizons"});
  expect_scene_error({"Coupling/Hourglass coefficient=-1"},
                     {"Coupling", "Hourglass coefficient", "-1"});
  expect_scene_error({"Coupling/Quadrature=half"}, {"Coupling", "Quadrature", "half"});
  expect_scene_error({"Coupling/Zones=automatic"}, {"Zones"});
}

TEST(CouplingSection, WhatDoesNotGoTogetherIsRefused)
{
  expect_scene_error({"Plate 1/Non-reflecting edges=true"},
                     {"Plate 1", "Non-reflecting edges", "Coupling"});
  EXPECT_TRUE(read_with({"Coupling/Zone=automatic", "Plate 1/Non-reflecting edges=true"})
                  .plates[0]
                  .absorbing_edges);
  for (const char *zone : {"everything", "none"})
    expect_scene_error({std::string("Coupling/Zone=") + zone, "Coupling/Adaptive=true"},
                       {"Coupling", "Adaptive", zone, "automatic"});
  expect_scene_error({"Coupling/Zone=boxes"}, {"Plate 1", "Zone box", "30 mm"});
}

TEST(CouplingSection, BoxesThatMissThePlateAreRefused)
{
  for (const char *box :
       {"90 mm, 30 mm, -20 mm, 20 mm", "30 mm, 90 mm, 20 mm, -20 mm", "30 mm, 30 mm, 0 mm, 10 mm",
        "250 mm, 300 mm, -20 mm, 20 mm", "-30 mm, 0 mm, -20 mm, 20 mm",
        "30 mm, 90 mm, 60 mm, 70 mm", "30 mm, 90 mm, -70 mm, -50 mm"})
    expect_scene_error({"Coupling/Zone=boxes", std::string("Plate 1/Zone box=") + box},
                       {"Plate 1", "Zone box"});
  expect_scene_error({"Coupling/Zone=boxes", "Plate 1/Zone box=30 mm, 90 mm, 10 mm"},
                     {"Plate 1", "Zone box"});
  expect_scene_error({"Coupling/Zone=boxes", "Plate 1/Zone box=30, 90, -10, 10"},
                     {"Plate 1", "Zone box"});
}
} // namespace
} // namespace ricochet::tests
