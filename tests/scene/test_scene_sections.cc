// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections that may stand in a file several times: projectiles with their impacts.
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
const std::string ball =
    "  set Nose shape = sphere\n  set Diameter = 5 mm\n  set Mass = 2 g\nend\n";
const std::string shot =
    "  set Speed = 100 m/s\n  set Incidence angle = 90 deg\n  set Entry point = 90 mm, 0 mm\nend\n";

std::string projectile(const int number)
{
  return "subsection Projectile " + std::to_string(number) + "\n" + ball;
}

std::string impact(const int number)
{
  return "subsection Impact " + std::to_string(number) + "\n" + shot;
}

Scene scene_of(const std::string &text)
{
  return read_scene(ParameterFile::from_text(text, "scene.prm"));
}

TEST(SceneSections, FurtherProjectilesAreReadWhereverTheyStand)
{
  const Scene one = scene_of(scene_text);
  EXPECT_EQ(one.n_projectiles(), 1u);
  const Scene scene = scene_of(impact(3) + projectile(2) + scene_text + projectile(3) + impact(2));
  ASSERT_EQ(scene.n_projectiles(), 3u);
  EXPECT_EQ(scene.projectile_at(0).mass, one.projectile.mass);
  EXPECT_EQ(scene.impact_at(0).entry_x, one.impact.entry_x);
  for (const std::size_t i : {1, 2})
  {
    EXPECT_EQ(scene.projectile_at(i).shape.nose, NoseShape::sphere);
    EXPECT_DOUBLE_EQ(scene.projectile_at(i).mass, 2e-3);
    EXPECT_DOUBLE_EQ(scene.impact_at(i).speed, 100.);
    EXPECT_DOUBLE_EQ(scene.impact_at(i).entry_x, 90e-3);
  }
  const Scene last = scene.with_only(2);
  EXPECT_EQ(last.n_projectiles(), 1u);
  EXPECT_DOUBLE_EQ(last.projectile.mass, 2e-3);
  EXPECT_DOUBLE_EQ(last.impact.speed, 100.);
}

TEST(SceneSections, OverridesReachFurtherProjectiles)
{
  const auto file = ParameterFile::from_text(
      scene_text + projectile(2) + impact(2), "scene.prm",
      parse_overrides({"Projectile 2/Mass=3 g", "Impact 2/Speed=50 m/s", "Impact/Speed=70 m/s"}));
  const Scene scene = read_scene(file);
  EXPECT_DOUBLE_EQ(scene.projectile_at(1).mass, 3e-3);
  EXPECT_DOUBLE_EQ(scene.impact_at(1).speed, 50.);
  EXPECT_DOUBLE_EQ(scene.impact_at(0).speed, 70.);
}

TEST(SceneSections, ProjectileAndImpactComeInPairs)
{
  expect_text_error(scene_text + projectile(2),
                    {"scene.prm:", "'Projectile 2' but no 'Impact 2'", "how it arrives"});
  expect_text_error(scene_text + impact(2), {"'Impact 2' but no 'Projectile 2'"});
  expect_text_error(scene_text + projectile(2) + impact(2) + projectile(3),
                    {"'Projectile 3' but no 'Impact 3'"});
}

TEST(SceneSections, ProjectilesAreNumberedWithoutGapsFromTwo)
{
  expect_text_error(scene_text + projectile(3) + impact(3),
                    {"'Projectile 3' but no 'Projectile 2'", "'Projectile 2', 'Projectile 3'"});
  expect_text_error(scene_text + projectile(2) + impact(3), {"'Impact 3' but no 'Impact 2'"});
  expect_text_error(scene_text + projectile(1) + impact(1),
                    {"no section 'Projectile 1'", "is called 'Projectile'"});
}

TEST(SceneSections, ComplaintsNameTheSectionOfTheProjectile)
{
  const auto with = [](const std::string &override)
  {
    return [override]
    {
      read_scene(ParameterFile::from_text(scene_text + projectile(2) + impact(2), "scene.prm",
                                          parse_overrides({override})));
    };
  };
  expect_error(with("Impact 2/Entry point=90 mm, 3 mm"),
               {"Impact 2/Entry point", "symmetric", "y = 0 mm"});
  expect_error(with("Impact 2/Entry point=290 mm, 0 mm"), {"Impact 2/Entry point", "first plate"});
  expect_error(with("Projectile 2/Length=3 mm"), {"Projectile 2/Length", "sphere"});
  expect_error(with("Projectile 2/Mass="), {"subsection Projectile 2", "set Mass = "});
}
} // namespace
} // namespace ricochet::tests
