// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/scene_text.h"

#include <cmath>

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

TEST(ProjectileEntries, ModalOneHasAsManyModesAsSaid)
{
  const std::vector<std::string> modal{"Projectile/Model=modal", E, nu};
  const auto by_default = read_scene(scene_with(modal)).projectile;
  EXPECT_EQ(by_default.model, ProjectileModel::modal);
  EXPECT_EQ(by_default.modes, 0); // automatic
  EXPECT_EQ(by_default.yield_stress, 0.);
  const auto given =
      read_with(with(modal, {"Projectile/Modes=12", "Projectile/Yield stress=1.5 GPa"})).projectile;
  EXPECT_EQ(given.modes, 12);
  EXPECT_EQ(given.yield_stress, 1.5e9);
  EXPECT_EQ(read_with(with(modal, {"Projectile/Modes=automatic"})).projectile.modes, 0);
  for (const char *wrong : {"0", "-3", "2.5", "many", "99999999999"})
    expect_scene_error(with(modal, {std::string("Projectile/Modes=") + wrong}),
                       {"Projectile/Modes", wrong, "number of modes", "automatic"});
  expect_scene_error(
      with(elements, {"Projectile/Modes=4"}),
      {"Projectile/Modes", "'finite elements' is not made of modes", "Model = modal"});
  expect_scene_error(with(elements, {"Projectile/Yield stress=1 GPa"}),
                     {"Projectile/Yield stress", "modal projectile alone"});
  expect_scene_error({"Projectile/Model=modal", nu, "Projectile/Young's modulus=0 GPa"},
                     {"Projectile/Young's modulus", "above 0"});
  expect_scene_error({"Projectile/Model=modal"}, {"Young's modulus"});
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

  expect_scene_error({nose[0], E, nu}, {"Grid spacing"});
  expect_scene_error(with(nose, {"Projectile/Peridynamic length=3 mm"}),
                     {"Peridynamic length = '3 mm'", "behind the nose", "before the base"});
  expect_scene_error(with(nose, {"Projectile/Peridynamic length=1 m"}), {"before the base"});
  expect_scene_error(with(nose, {"Projectile/Nose shape=flat", "Projectile/Nose length="}),
                     {"Peridynamic length", "no length of its own"});
  expect_scene_error(
      with(nose, {"Projectile/Nose shape=sphere", "Projectile/Nose length=", "Projectile/Length="}),
      {"Projectile/Model", "all nose", "'finite elements'"});
}

TEST(ProjectileEntries, DeformableModelsNeedTheirConstants)
{
  expect_scene_error({is_elements}, {"Young's modulus"});
  expect_scene_error(points, {"Grid spacing"});
  expect_scene_error({is_elements, E, "Projectile/Poisson's ratio=0.5"},
                     {"Poisson's ratio", "0.3"});
  expect_scene_error(with(elements, {"Projectile/Refinement=2.5"}), {"Refinement", "whole number"});
  expect_scene_error(with(elements, {"Projectile/Refinement=5"}), {"Choose 1, 2, 3 or 4"});
  expect_scene_error({"Projectile/Model=plastic"}, {"finite elements"});
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

TEST(ProjectileEntries, CaliberRadiusHeadGivesTheNoseLength)
{
  const Scene scene = read_with({"Projectile/Nose length=", "Projectile/Caliber radius head=3"});
  // A tangent ogive: l = d sqrt(CRH - 1/4).
  EXPECT_DOUBLE_EQ(scene.projectile.shape.nose_length, 6e-3 * std::sqrt(2.75));
  expect_scene_error({"Projectile/Caliber radius head=3"}, {"'Nose length' (scene.prm:6)"});
  expect_scene_error({"Projectile/Nose length="},
                     {"set Nose length", "or: set Caliber radius head = 3"});
  expect_scene_error({"Projectile/Nose length=", "Projectile/Caliber radius head=0.4"},
                     {"'0.4'", "0.5"});
}

TEST(ProjectileEntries, OnlyOgiveAndConeHaveANoseLength)
{
  expect_scene_error({"Projectile/Nose shape=flat"},
                     {"scene.prm:6", "Nose length", "'flat'", "Remove"});
  expect_scene_error(
      {"Projectile/Nose shape=cone", "Projectile/Nose length=", "Projectile/Caliber radius head=3"},
      {"missing", "set Nose length"});
  expect_scene_error({"Projectile/Nose shape=cone", "Projectile/Caliber radius head=3"},
                     {"command line", "Caliber radius head", "'cone'"});
  EXPECT_DOUBLE_EQ(read_with({"Projectile/Nose shape=hemisphere", "Projectile/Nose length="})
                       .projectile.shape.nose_length,
                   3e-3); // half the diameter
}

TEST(ProjectileEntries, ASphereHasADiameterOnly)
{
  const Scene scene =
      read_with({"Projectile/Nose shape=sphere", "Projectile/Length=", "Projectile/Nose length=",
                 "Projectile/Mass=", "Projectile/Density=7850 kg/m3"});
  EXPECT_EQ(scene.projectile.shape.nose, NoseShape::sphere);
  const double volume = 4. / 3. * M_PI * std::pow(3e-3, 3);
  EXPECT_NEAR(scene.projectile.mass, 7850. * volume, 1e-12 * scene.projectile.mass); // rounding
  expect_scene_error({"Projectile/Nose shape=sphere", "Projectile/Nose length="},
                     {"Length", "'sphere'", "Remove"});
}

TEST(ProjectileEntries, DensityTimesVolumeGivesTheMass)
{
  const Scene scene =
      read_with({"Projectile/Nose shape=flat",
                 "Projectile/Nose length=", "Projectile/Mass=", "Projectile/Density=7850 kg/m3"});
  const double volume = M_PI * 3e-3 * 3e-3 * 28e-3;                                  // a cylinder
  EXPECT_NEAR(scene.projectile.mass, 7850. * volume, 1e-12 * scene.projectile.mass); // rounding
  expect_scene_error({"Projectile/Density=7850 kg/m3"}, {"'Mass' (scene.prm:7)", "Keep one"});
  expect_scene_error({"Projectile/Mass="}, {"set Mass = 5.25 g", "or: set Density"});
}

TEST(ProjectileEntries, ImpossibleProjectileIsRejected)
{
  expect_scene_error({"Projectile/Nose length=30 mm"}, {"command line", "longer", "'Projectile'"});
  expect_scene_error({"Projectile/Nose length=2 mm"}, {"command line", "ogive", "'Projectile'"});
}
} // namespace
} // namespace ricochet::tests
