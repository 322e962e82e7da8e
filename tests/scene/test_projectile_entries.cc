// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/scene_reader.h"
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
const std::string is_elements = "Projectile/Model=finite elements",
                  is_points   = "Projectile/Model=peridynamic",
                  E = "Projectile/Young's modulus=202 GPa", nu = "Projectile/Poisson's ratio=0.3";
const std::vector<std::string> elements{is_elements, E, nu}, points{is_points, E, nu};

std::vector<std::string> with(std::vector<std::string> overrides,
                              const std::vector<std::string> &more)
{
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

void expect_refused(const std::vector<std::string> &overrides,
                    const std::vector<std::string> &parts)
{
  expect_error([&] { read_scene(scene_with(overrides)); }, parts);
}

TEST(ProjectileEntries, ModelIsRigidUnlessSaid)
{
  EXPECT_EQ(read_scene(scene_with({})).projectile.model, ProjectileModel::rigid);
  const auto projectile =
      read_scene(scene_with(with(elements, {"Projectile/Refinement=3"}))).projectile;
  EXPECT_EQ(projectile.model, ProjectileModel::finite_elements);
  EXPECT_EQ(projectile.youngs_modulus, 202e9);
  EXPECT_EQ(projectile.poissons_ratio, 0.3);
  EXPECT_EQ(projectile.refinement, 3);
  EXPECT_TRUE(projectile.mesh.cells.empty());
  const auto lattice =
      read_scene(scene_with(with(points, {"Projectile/Grid spacing=0.75 mm"}))).projectile;
  EXPECT_EQ(lattice.model, ProjectileModel::peridynamic);
  EXPECT_DOUBLE_EQ(lattice.spacing, 0.75e-3);
}

TEST(ProjectileEntries, PeridynamicNoseReachesBackAsFarAsSaid)
{
  const std::vector<std::string> nose{"Projectile/Model=peridynamic nose", E, nu,
                                      "Projectile/Grid spacing=0.75 mm"};
  const auto by_default = read_scene(scene_with(nose)).projectile;
  EXPECT_EQ(by_default.model, ProjectileModel::peridynamic_nose);
  EXPECT_EQ(by_default.peridynamic_length, by_default.shape.nose_length);
  EXPECT_DOUBLE_EQ(read_scene(scene_with(with(nose, {"Projectile/Peridynamic length=15 mm"})))
                       .projectile.peridynamic_length,
                   15e-3);

  expect_refused({nose[0], E, nu}, {"Grid spacing"});
  expect_refused(with(nose, {"Projectile/Peridynamic length=3 mm"}),
                 {"Peridynamic length = '3 mm'", "behind the nose", "before the base"});
  expect_refused(with(nose, {"Projectile/Peridynamic length=1 m"}), {"before the base"});
  expect_refused(with(nose, {"Projectile/Nose shape=flat", "Projectile/Nose length="}),
                 {"Peridynamic length", "no length of its own"});
  expect_refused(
      with(nose, {"Projectile/Nose shape=sphere", "Projectile/Nose length=", "Projectile/Length="}),
      {"Projectile/Model", "all nose", "'finite elements'"});
}

TEST(ProjectileEntries, DeformableModelsNeedTheirConstants)
{
  expect_refused({is_elements}, {"Young's modulus"});
  expect_refused(points, {"Grid spacing"});
  expect_refused({is_elements, E, "Projectile/Poisson's ratio=0.5"}, {"Poisson's ratio", "0.3"});
  expect_refused(with(elements, {"Projectile/Refinement=2.5"}), {"Refinement", "whole number"});
  expect_refused(with(elements, {"Projectile/Refinement=5"}), {"Choose 1, 2, 3 or 4"});
  expect_refused({"Projectile/Model=plastic"}, {"finite elements"});
}

TEST(ProjectileEntries, MeshFileIsRead)
{
  const std::string file = RICOCHET_SOURCE_DIR "/meshes/core_030_1.msh";
  const auto projectile =
      read_scene(scene_with(with(elements, {"Projectile/Mesh=" + file}))).projectile;
  EXPECT_EQ(projectile.mesh.cells.size(), 160u);
  EXPECT_LT(volume(projectile.mesh), 1e-6); // millimetres by default
  expect_error<FileError>(
      [&] { read_scene(scene_with(with(elements, {"Projectile/Mesh=nothing.msh"}))); },
      {"nothing.msh", "cannot be read"});
}
} // namespace
} // namespace ricochet::tests
