// SPDX-License-Identifier: LGPL-2.1-or-later
// used.prm: what a run used, to be read again.
#include "support/scene_text.h"

#include <sstream>

namespace ricochet::tests
{
namespace
{
void expect_equal(const Scene &a, const Scene &b)
{
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.symmetric, b.symmetric);
  EXPECT_EQ(a.projectile.shape.nose, b.projectile.shape.nose);
  EXPECT_EQ(a.projectile.shape.nose_length, b.projectile.shape.nose_length);
  EXPECT_EQ(a.projectile.mass, b.projectile.mass);
  EXPECT_EQ(a.impact.speed, b.impact.speed);
  EXPECT_EQ(a.impact.incidence_angle, b.impact.incidence_angle);
  EXPECT_EQ(a.impact.attack_angle, b.impact.attack_angle);
  EXPECT_EQ(a.impact.entry_x, b.impact.entry_x);
  EXPECT_EQ(a.impact.clearance, b.impact.clearance);
  ASSERT_EQ(a.plates.size(), b.plates.size());
  EXPECT_EQ(a.plates[0].thickness, b.plates[0].thickness);
  EXPECT_EQ(a.plates[0].spacing, b.plates[0].spacing);
  EXPECT_EQ(a.plates[0].influence_function, b.plates[0].influence_function);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  EXPECT_EQ(a.materials[0].bulk_modulus, b.materials[0].bulk_modulus);
  EXPECT_EQ(a.materials[0].shear_modulus, b.materials[0].shear_modulus);
  EXPECT_EQ(a.materials[0].energy_release, b.materials[0].energy_release);
  ASSERT_EQ(a.materials[0].relaxation.size(), b.materials[0].relaxation.size());
  for (std::size_t k = 0; k < a.materials[0].relaxation.size(); ++k)
    EXPECT_EQ(a.materials[0].relaxation[k].time, b.materials[0].relaxation[k].time);
  EXPECT_EQ(std::get<ExponentialFriction::Parameters>(a.contact.friction).decay,
            std::get<ExponentialFriction::Parameters>(b.contact.friction).decay);
  EXPECT_EQ(a.contact.debris_factor, b.contact.debris_factor);
  EXPECT_EQ(a.contact.debris_friction, b.contact.debris_friction);
  EXPECT_EQ(a.time.end_time, b.time.end_time);
  EXPECT_EQ(a.time.stop_early, b.time.stop_early);
  EXPECT_EQ(a.output.directory, b.output.directory);
  EXPECT_EQ(a.output.pictures, b.output.pictures);
}

TEST(UsedParameters, ReadAgainGiveTheSameScene)
{
  const auto file = scene_with(
      {"Projectile/Nose length=", "Projectile/Caliber radius head=3",
       "Projectile/Mass=", "Projectile/Density=7.85 g/cm3", "Material PMMA/Bulk modulus=",
       "Material PMMA/Shear modulus=", "Material PMMA/Young's modulus=6 GPa",
       "Material PMMA/Poisson's ratio=0.3",
       "Material PMMA/Critical stretch=", "Material PMMA/Energy release rate=500 J/m2",
       "Material PMMA/Relaxation shares=0.1, 0.2", "Material PMMA/Relaxation times=3 ms, 95.4 us",
       "Plate 1/Influence function=gaussian", "Output/Pictures=false"});
  std::ostringstream used;
  write_used_parameters(file, used);
  // Another file name, so that a default that depends on it would show.
  expect_equal(read_scene(file), read_scene(ParameterFile::from_text(used.str(), "used.prm")));
}

TEST(UsedParameters, KeepUnitsAndMarkDefaults)
{
  std::ostringstream used;
  write_used_parameters(scene_with({}), used);
  const std::string text = used.str();
  EXPECT_NE(text.find("set Speed           = 0.72 mm/us\n"), std::string::npos) << text;
  EXPECT_NE(text.find("set Attack angle    = 0 deg # default\n"), std::string::npos) << text;
  EXPECT_NE(text.find("set Directory                      = output/scene # default\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("Caliber radius head"), std::string::npos) << text;
}
} // namespace
} // namespace ricochet::tests
