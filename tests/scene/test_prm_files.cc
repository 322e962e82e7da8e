// SPDX-License-Identifier: LGPL-2.1-or-later
// Every parameter file of the project is read: scenes as scenes, studies as studies.
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/study_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace ricochet
{
namespace
{
const std::filesystem::path prm_folder = std::filesystem::path(RICOCHET_SOURCE_DIR) / "prm";

/// Whether it has nothing but a section Material.
bool is_material(const std::string &path)
{
  const ParameterFile file(path);
  return file.sections().size() == 1 && file.sections()[0].name.rfind("Material ", 0) == 0;
}

TEST(PrmFiles, EveryFileIsReadWithoutError)
{
  unsigned int n_scenes = 0, n_studies = 0, n_experiments = 0, n_materials = 0;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(prm_folder))
    if (entry.path().extension() == ".prm")
    {
      const std::string path = entry.path().string();
      if (is_study_file(ParameterFile(path)))
      {
        ++n_studies;
        EXPECT_NO_THROW(read_study(path)) << path;
      }
      else if (is_stability_file(ParameterFile(path)))
      {
        ++n_experiments;
        EXPECT_NO_THROW(read_stability(ParameterFile(path))) << path;
      }
      else if (is_material(path)) // only to be included
        ++n_materials;
      else
      {
        ++n_scenes;
        EXPECT_NO_THROW(read_scene(ParameterFile(path))) << path;
      }
    }
  EXPECT_GE(n_scenes, 8U); // quickstart and the single plate
  EXPECT_GE(n_studies, 1U);
  EXPECT_GE(n_experiments, 4U);
  EXPECT_EQ(n_materials, 1U);
}

TEST(PrmFiles, SinglePlateSeriesChangesOneThingPerFile)
{
  const auto scene = [](const std::string &name)
  { return read_scene(ParameterFile((prm_folder / "single_plate" / (name + ".prm")).string())); };
  const Scene base = scene("base");
  for (const int angle : {10, 20, 45, 60})
  {
    const Scene other = scene("angle_" + std::to_string(angle));
    EXPECT_NEAR(other.impact.incidence_angle, angle * 3.14159265358979 / 180., 1e-12);
    EXPECT_EQ(other.impact.speed, base.impact.speed);
    EXPECT_EQ(other.materials[0].critical_stretch, base.materials[0].critical_stretch);
  }
  for (const int speed : {500, 800})
  {
    const Scene other = scene("speed_" + std::to_string(speed));
    EXPECT_DOUBLE_EQ(other.impact.speed, speed);
    EXPECT_EQ(other.impact.incidence_angle, base.impact.incidence_angle);
    EXPECT_EQ(other.materials[0].critical_stretch, base.materials[0].critical_stretch);
  }
}

TEST(PrmFiles, ViscoelasticBaseAddsRelaxationToTheSinglePlate)
{
  const auto scene = [](const std::string &folder)
  { return read_scene(ParameterFile((prm_folder / folder / "base.prm").string())); };
  const Scene elastic = scene("single_plate"), relaxing = scene("viscoelastic");
  EXPECT_TRUE(elastic.materials[0].relaxation.empty());
  ASSERT_EQ(relaxing.materials[0].relaxation.size(), 2U);
  // Wang's ZWT set for PMMA at K = 5.9 GPa: 0.707 GPa are left in the long run.
  EXPECT_NEAR(relaxing.materials[0].shear_modulus *
                  relaxed_share(relaxing.materials[0].relaxation, 1e9),
              0.707e9, 1e6);
  EXPECT_EQ(relaxing.impact.speed, elastic.impact.speed);
  // One set of constants for both speeds and for three plates.
  for (const char *other : {"speed_800", "full", "full_calibre", "three_layers"})
  {
    const Scene scene = read_scene(
        ParameterFile((prm_folder / "viscoelastic" / (std::string(other) + ".prm")).string()));
    EXPECT_EQ(scene.materials[0].critical_stretch, relaxing.materials[0].critical_stretch) << other;
    EXPECT_EQ(scene.materials[0].relaxation.size(), 2U) << other;
    const auto friction = [](const Scene &one)
    { return std::get<ExponentialFriction::Parameters>(one.contact.friction); };
    EXPECT_EQ(friction(scene).kinetic_coefficient, friction(relaxing).kinetic_coefficient) << other;
    EXPECT_EQ(friction(scene).decay, friction(relaxing).decay) << other;
  }
}

TEST(PrmFiles, SinglePlateStudyHasAllCasesOnTwoGrids)
{
  const StudyParameters study = read_study((prm_folder / "single_plate" / "study.prm").string());
  EXPECT_EQ(study.scenes.size(), 7U);
  EXPECT_EQ(study.cases.size(), 14U);
  EXPECT_EQ(study.cases[2].name, "angle_10__grid_spacing_1.5_mm");
}

TEST(PrmFiles, CoupledStudiesCompareEnsemblesWithPeridynamicsThroughout)
{
  for (const auto &[name, n_cases] :
       {std::pair("accuracy", 40U), {"plate_size", 36U}, {"cases", 72U}})
  {
    const auto study = read_study((prm_folder / "coupled" / (std::string(name) + ".prm")).string());
    EXPECT_EQ(study.reference, "base_full") << name;
    EXPECT_EQ(study.cases.size(), n_cases) << name;
    EXPECT_TRUE(study.axes.back().is_ensemble) << name;
    EXPECT_GE(study.axes.back().values.size(), 4U) << name;
    for (const auto &one : study.cases) // what is timed writes no pictures and no fields
    {
      const Scene scene = read_scene(one.file);
      EXPECT_FALSE(scene.output.pictures || scene.output.vtu) << one.name;
      EXPECT_EQ(scene.output.frame_interval, 0.) << one.name;
    }
  }
}
} // namespace
} // namespace ricochet
