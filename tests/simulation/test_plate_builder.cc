// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simulation/plate_builder.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/simulation/plate_zone.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(PlateBuilder, PlatesLieBelowOneAnother)
{
  for (const bool half : {false, true})
  {
    Scene scene         = two_plates();
    scene.symmetric     = half;
    scene.plates[0].gap = 7e-3; // above the first there is none
    scene.plates[1].gap = 2e-3;
    const auto plates   = build_plates(MPI_COMM_SELF, scene);
    const auto &first   = plates[0].points->lattice().box();
    const auto &second  = plates[1].points->lattice().box();
    const double bottom = first.corner.z();
    const double top    = second.corner.z() + second.n[2] * second.spacing;
    EXPECT_NEAR(bottom + first.n[2] * first.spacing, 0., 1e-15);
    EXPECT_NEAR(bottom - top, 2e-3, 1e-15);
    for (const auto *box : {&first, &second})
    {
      EXPECT_EQ(box->corner.x(), 0.);
      EXPECT_NEAR(box->corner.y(), half ? 0. : -8e-3, 1e-15);
      EXPECT_EQ(box->n, (std::array<int, 3>{30, half ? 8 : 16, 4}));
      EXPECT_EQ(box->mirror_y, half);
    }
    EXPECT_EQ(plates[0].coupled, nullptr);
    EXPECT_EQ(plates[0].body.get(), plates[0].points);
  }
}

TEST(PlateBuilder, EachPlateHasTheMaterialItNames)
{
  Scene scene = two_plates();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name    = "lead";
  scene.materials[1].density = 11340.;
  scene.plates[1].material   = "lead";
  EXPECT_EQ(material_of(scene, scene.plates[0]).density, 1190.);
  EXPECT_EQ(material_of(scene, scene.plates[1]).density, 11340.);
  const auto plates = build_plates(MPI_COMM_SELF, scene);
  // A cube of 1 mm each.
  EXPECT_NEAR(plates[0].points->point_mass(), 1190e-9, 1e-18);
  EXPECT_NEAR(plates[1].points->point_mass(), 11340e-9, 1e-17);
  scene.plates[1].material = "gold";
  EXPECT_THROW(build_plates(MPI_COMM_SELF, scene), InputError);
}

TEST(PlateBuilder, CriticalStretchComesFromTheEnergyReleaseUnlessGiven)
{
  const Scene scene = small_scene();
  const auto stencil =
      make_stencil(scene.plates[0].spacing, scene.plates[0].horizon_ratio, InfluenceFunction::cone);
  auto material = scene.materials[0];
  EXPECT_EQ(critical_stretch(material, stencil), 0.01);
  material.critical_stretch = 0.;
  material.energy_release   = 500.;
  const double once         = critical_stretch(material, stencil);
  material.energy_release   = 2000.;
  EXPECT_GT(once, 0.);
  EXPECT_NEAR(critical_stretch(material, stencil) / once, 2., 1e-12); // G ~ s^2
}
} // namespace
} // namespace ricochet::tests
