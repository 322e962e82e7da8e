// SPDX-License-Identifier: LGPL-2.1-or-later
// From a parameter file to a scene: values, defaults, errors. Projectile, material and coupling
// have files of their own.
#include "support/scene_text.h"

#include <cmath>

namespace ricochet::tests
{
namespace
{
TEST(SceneReader, ValuesArriveInSi)
{
  const Scene scene = read_with({});
  EXPECT_EQ(scene.title, "Test");
  EXPECT_EQ(scene.projectile.shape.nose, NoseShape::ogive);
  EXPECT_DOUBLE_EQ(scene.projectile.shape.diameter, 6e-3);
  EXPECT_DOUBLE_EQ(scene.projectile.shape.length, 28e-3);
  EXPECT_DOUBLE_EQ(scene.projectile.shape.nose_length, 10e-3);
  EXPECT_DOUBLE_EQ(scene.projectile.mass, 5e-3);
  EXPECT_DOUBLE_EQ(scene.impact.speed, 720.);
  EXPECT_DOUBLE_EQ(scene.impact.incidence_angle, M_PI / 6.);
  EXPECT_DOUBLE_EQ(scene.impact.entry_x, 50e-3);
  EXPECT_EQ(scene.impact.entry_y, 0.);
  ASSERT_EQ(scene.plates.size(), 1U);
  EXPECT_DOUBLE_EQ(scene.plates[0].length, 0.2);
  EXPECT_DOUBLE_EQ(scene.plates[0].width, 0.1);
  EXPECT_DOUBLE_EQ(scene.plates[0].thickness, 0.03);
  EXPECT_DOUBLE_EQ(scene.plates[0].spacing, 2e-3);
  EXPECT_EQ(scene.plates[0].material, "PMMA");
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].name, "PMMA");
  EXPECT_DOUBLE_EQ(scene.materials[0].density, 1190.);
  EXPECT_DOUBLE_EQ(scene.materials[0].bulk_modulus, 5.9e9);
  EXPECT_DOUBLE_EQ(scene.materials[0].shear_modulus, 2.258e9);
  EXPECT_DOUBLE_EQ(scene.materials[0].critical_stretch, 0.01);
  EXPECT_EQ(scene.materials[0].energy_release, 0.);
  const auto &friction = std::get<ExponentialFriction::Parameters>(scene.contact.friction);
  EXPECT_DOUBLE_EQ(friction.static_coefficient, 0.5);
  EXPECT_DOUBLE_EQ(friction.kinetic_coefficient, 0.05);
  EXPECT_DOUBLE_EQ(friction.decay, 0.01);
  EXPECT_DOUBLE_EQ(scene.time.end_time, 450e-6);
}

TEST(SceneReader, DefaultsAreFilledIn)
{
  const Scene scene = read_with({"Title="});
  EXPECT_EQ(scene.title, "scene");
  EXPECT_TRUE(scene.symmetric);
  EXPECT_EQ(scene.impact.attack_angle, 0.);
  EXPECT_DOUBLE_EQ(scene.impact.clearance, 0.05e-3);
  EXPECT_EQ(scene.plates[0].horizon_ratio, 3.);
  EXPECT_EQ(scene.plates[0].influence_function, InfluenceFunction::cone);
  EXPECT_EQ(scene.plates[0].gap, 0.);
  EXPECT_EQ(scene.materials[0].bond_model, "linear peridynamic solid");
  EXPECT_EQ(scene.contact.stiffness_factor, 1.);
  EXPECT_EQ(scene.contact.regularisation_speed, 5.);
  EXPECT_DOUBLE_EQ(scene.contact.shank_resistance, 500e6);
  EXPECT_DOUBLE_EQ(scene.contact.shank_contact_fraction, 0.4);
  EXPECT_EQ(scene.contact.debris_factor, 1.);
  EXPECT_EQ(scene.contact.debris_friction, 0.);
  EXPECT_TRUE(scene.output.picture_times.empty());
  EXPECT_DOUBLE_EQ(scene.time.safety_factor, 0.7);
  EXPECT_TRUE(scene.time.stop_early);
  EXPECT_DOUBLE_EQ(scene.time.free_time, 5e-6);
  EXPECT_EQ(scene.output.directory, "output/scene");
  EXPECT_DOUBLE_EQ(scene.output.frame_interval, 20e-6);
  EXPECT_DOUBLE_EQ(scene.output.history_interval, 2e-6);
  EXPECT_TRUE(scene.output.vtu);
  EXPECT_TRUE(scene.output.pictures);
}

TEST(SceneReader, DebrisThatDoesNotRepelCannotRub)
{
  EXPECT_EQ(read_with({"Contact/Debris stiffness factor=0"}).contact.debris_factor, 0.);
  expect_scene_error({"Contact/Debris stiffness factor=0", "Contact/Debris friction factor=0.4"},
                     {"Contact/Debris friction factor", "nothing to rub against", "above 0"});
}

TEST(SceneReader, PictureTimesMustAscend)
{
  expect_scene_error({"Output/Picture times=45 us, 45 us"},
                     {"Output/Picture times", "Time 2 does not come after time 1", "ascending"});
  expect_scene_error({"Output/Picture times=45 us, 94"}, {"Value 2", "The unit is missing"});
  expect_scene_error({"Output/Picture times=45 us,"}, {"Output/Picture times"});
}

TEST(SceneReader, OptionalEntriesAreRead)
{
  const Scene scene = read_with({"Symmetric=false",
                                 "Impact/Attack angle=-3 deg",
                                 "Impact/Entry point=50 mm, -3 mm",
                                 "Impact/Clearance=0.1 mm",
                                 "Plate 1/Influence function=inverse",
                                 "Plate 1/Horizon ratio=4.01",
                                 "Contact/Stiffness factor=2",
                                 "Contact/Debris stiffness factor=0.2",
                                 "Contact/Debris friction factor=0.4",
                                 "Contact/Shank contact fraction=0",
                                 "Contact/Shank resistance=0 Pa",
                                 "Contact/Regularisation speed=1 m/s",
                                 "Time/Safety factor=0.5",
                                 "Time/Stop early=false",
                                 "Time/Free time=9 us",
                                 "Output/Directory=there",
                                 "Output/Frame interval=0 us",
                                 "Output/History interval=2 us",
                                 "Output/ParaView files=false",
                                 "Output/Pictures=false",
                                 "Output/Picture times=0 us, 45 us"});
  EXPECT_FALSE(scene.symmetric);
  EXPECT_DOUBLE_EQ(scene.impact.attack_angle, -M_PI / 60.);
  EXPECT_DOUBLE_EQ(scene.impact.entry_y, -3e-3);
  EXPECT_DOUBLE_EQ(scene.impact.clearance, 0.1e-3);
  EXPECT_EQ(scene.plates[0].influence_function, InfluenceFunction::inverse);
  EXPECT_DOUBLE_EQ(scene.plates[0].horizon_ratio, 4.01);
  EXPECT_EQ(scene.contact.stiffness_factor, 2.);
  EXPECT_EQ(scene.contact.debris_factor, 0.2);
  EXPECT_EQ(scene.contact.debris_friction, 0.4);
  ASSERT_EQ(scene.output.picture_times.size(), 2u);
  EXPECT_EQ(scene.output.picture_times[0], 0.);
  EXPECT_DOUBLE_EQ(scene.output.picture_times[1], 45e-6);
  EXPECT_EQ(scene.contact.shank_contact_fraction, 0.);
  EXPECT_EQ(scene.contact.shank_resistance, 0.);
  EXPECT_EQ(scene.contact.regularisation_speed, 1.);
  EXPECT_DOUBLE_EQ(scene.time.safety_factor, 0.5);
  EXPECT_FALSE(scene.time.stop_early);
  EXPECT_DOUBLE_EQ(scene.time.free_time, 9e-6);
  EXPECT_EQ(scene.output.directory, "there");
  EXPECT_EQ(scene.output.frame_interval, 0.);
  EXPECT_DOUBLE_EQ(scene.output.history_interval, 2e-6);
  EXPECT_FALSE(scene.output.vtu);
  EXPECT_FALSE(scene.output.pictures);
}

TEST(SceneReader, PlatesAreInOrderOfTheirNumbers)
{
  const std::string plate = "set Size = 100 mm, 100 mm, 20 mm\nset Grid spacing = 2 mm\n"
                            "set Material = PMMA\nend\n";
  const Scene scene       = read_scene(
            ParameterFile::from_text("subsection Plate 3\nset Gap = 3 mm\n" + plate +
                                         "subsection Plate 2\nset Gap = 2 mm\n" + plate + scene_text,
                                     "scene.prm"));
  ASSERT_EQ(scene.plates.size(), 3U);
  EXPECT_EQ(scene.plates[0].gap, 0.);
  EXPECT_DOUBLE_EQ(scene.plates[1].gap, 2e-3);
  EXPECT_DOUBLE_EQ(scene.plates[2].gap, 3e-3);
}

TEST(SceneReader, PlateNumbersHaveNoHoles)
{
  expect_text_error(scene_text + "subsection Plate 3\nend\n",
                    {"scene.prm:34", "'Plate 3'", "no 'Plate 2'", "1, 2, 3"});
}

TEST(SceneReader, HorizonIsAtLeastTwoSpacings)
{
  expect_scene_error({"Plate 1/Horizon ratio=1.9"},
                     {"command line", "'1.9'", "A horizon under 2 spacings", "2 or more"});
  EXPECT_EQ(read_with({"Plate 1/Horizon ratio=2"}).plates[0].horizon_ratio, 2.);
}

TEST(SceneReader, PlateIsNotThinnerThanItsHorizon)
{
  expect_scene_error({"Plate 1/Horizon ratio=6", "Plate 1/Size=200 mm, 100 mm, 11 mm"},
                     {"command line", "thinner than its horizon, 12 mm", "1.83 mm or less"});
  const Scene scene = read_with({"Plate 1/Horizon ratio=6", "Plate 1/Size=200 mm, 100 mm, 12 mm"});
  EXPECT_DOUBLE_EQ(scene.plates[0].thickness, 0.012);
}

TEST(SceneReader, AtLeastFourPointsAlongEachAxis)
{
  expect_scene_error({"Plate 1/Size=200 mm, 100 mm, 6 mm"},
                     {"scene.prm:16", "thickness of 6 mm holds 3 points", "1.5 mm or less"});
  expect_scene_error({"Plate 1/Size=200 mm, 12 mm, 30 mm"}, {"half width of 6 mm holds 3 points"});
  expect_scene_error({"Plate 1/Size=6 mm, 100 mm, 30 mm"}, {"length of 6 mm holds 3 points"});
  EXPECT_DOUBLE_EQ(
      read_with({"Symmetric=false", "Plate 1/Size=200 mm, 12 mm, 30 mm"}).plates[0].width, 0.012);
}

TEST(SceneReader, MorePointsThanCanBeNumberedAreRejected)
{
  expect_scene_error({"Plate 1/Grid spacing=20 um"}, {"3.75e+10 points", "2e+09"});
}

TEST(SceneReader, FirstPlateHasNoGap)
{
  expect_scene_error({"Plate 1/Gap=1 mm"}, {"command line", "no plate above"});
}

TEST(SceneReader, MaterialOfAPlateExists)
{
  expect_scene_error({"Plate 1/Material=PMA"},
                     {"command line", "'Material PMA'", "did you mean 'PMMA'?"});
}

TEST(SceneReader, AnglesAreInTheirRange)
{
  expect_scene_error({"Impact/Incidence angle=90.1 deg"}, {"'90.1 deg'", "at most 90 deg"});
  expect_scene_error({"Impact/Incidence angle=0 deg"}, {"'0 deg'", "above 0"});
  expect_scene_error({"Impact/Attack angle=90 deg"}, {"'90 deg'", "between -90 deg and 90 deg"});
  EXPECT_DOUBLE_EQ(read_with({"Impact/Incidence angle=90 deg"}).impact.incidence_angle, M_PI / 2.);
}

TEST(SceneReader, EntryPointIsOnThePlate)
{
  expect_scene_error({"Impact/Entry point=201 mm, 0 mm"},
                     {"not on the first plate", "0 mm and 200 mm", "-50 mm and 50 mm"});
  expect_scene_error({"Impact/Entry point=-1 mm, 0 mm"}, {"not on the first plate"});
  expect_scene_error({"Symmetric=false", "Impact/Entry point=50 mm, 51 mm"},
                     {"not on the first plate"});
}

TEST(SceneReader, YawAndSpinNeedTheFullModel)
{
  const auto impact =
      read_with({"Symmetric=false", "Impact/Yaw angle=3 deg", "Impact/Spin=100 rev/s"}).impact;
  EXPECT_NEAR(impact.yaw_angle, 3. * M_PI / 180., 1e-15);
  EXPECT_NEAR(impact.spin, 200. * M_PI, 1e-12 * impact.spin);
  EXPECT_EQ(read_with({}).impact.spin, 0.);
  for (const char *entry : {"Yaw angle=3 deg", "Spin=100 rev/s"})
    expect_scene_error({std::string("Impact/") + entry},
                       {"Impact/", "neither yaw nor spin", "Symmetric = false"});
  expect_scene_error({"Symmetric=false", "Impact/Yaw angle=95 deg"},
                     {"Impact/Yaw angle", "sideways"});
}

TEST(SceneReader, SymmetricModelIsHitInItsMidPlane)
{
  expect_scene_error({"Impact/Entry point=50 mm, 1 mm"},
                     {"command line", "y = 0 mm", "'set Symmetric = false'"});
}

TEST(SceneReader, SafetyFactorIsAtMostOne)
{
  expect_scene_error({"Time/Safety factor=1.1"}, {"'1.1'", "not above 1"});
}

TEST(SceneReader, FrictionNeedsWhatItsLawReads)
{
  expect_scene_error({"Contact/Kinetic friction=", "Contact/Friction decay="},
                     {"2 entries", "set Kinetic friction", "set Friction decay"});
  const Scene constant = read_with(
      {"Contact/Friction law=constant", "Contact/Kinetic friction=", "Contact/Friction decay="});
  EXPECT_EQ(std::get<ConstantFriction::Parameters>(constant.contact.friction).static_coefficient,
            0.5);
  // What another law would read may stand in the file.
  EXPECT_EQ(FrictionLaws::name(read_with({"Contact/Friction law=constant"}).contact.friction),
            "constant");
}

TEST(SceneReader, ConstantOfOneFrictionLawIsReadAndAskedForWithItAlone)
{
  const std::string law = "Contact/Friction law=flash heating";
  const Scene scene     = read_with({law, "Contact/Weakening speed=0.12 m/s"});
  const auto &friction  = std::get<FlashHeatingFriction::Parameters>(scene.contact.friction);
  EXPECT_DOUBLE_EQ(friction.static_coefficient, 0.5);
  EXPECT_DOUBLE_EQ(friction.kinetic_coefficient, 0.05);
  EXPECT_DOUBLE_EQ(friction.weakening_speed, 0.12);
  expect_scene_error({law}, {"An entry", "subsection Contact", "set Weakening speed = 1 m/s"});
  expect_scene_error({law, "Contact/Weakening speed=1"},
                     {"Contact/Weakening speed = '1'", "unit is missing", "a speed above 0"});
}

TEST(SceneReader, NamesOutsideTheMenusShowTheMenu)
{
  expect_scene_error({"Plate 1/Influence function=kone"},
                     {"'kone'", "did you mean 'cone'?", "gaussian"});
  expect_scene_error({"Contact/Friction law=coulomb"}, {"'coulomb'", "exponential", "constant"});
  expect_scene_error({"Material PMMA/Bond model=linear"},
                     {"'linear'", "linear peridynamic solid", "microelastic brittle"});
  expect_scene_error({"Projectile/Nose shape=ogiv"}, {"did you mean 'ogive'?", "hemisphere"});
  expect_scene_error({"Symmetric=yes"}, {"'yes'", "true or false"});
}

TEST(SceneReader, WrongValueNamesLineValueAndExpectedForm)
{
  expect_text_error("subsection Impact\n  set Speed = 720\nend\n",
                    {"scene.prm:2", "Impact/Speed = '720'", "The unit is missing.",
                     "Expected: a speed above 0 in m/s", "for example '720 m/s'"});
  expect_scene_error({"Plate 1/Grid spacing=1 us"},
                     {"command line", "'us' is a unit of time", "a length above 0"});
}

TEST(SceneReader, UnknownEntrySuggestsTheNearestOne)
{
  expect_text_error("subsection Impact\n  set Sped = 720 m/s\nend\n",
                    {"scene.prm:2", "'Sped'", "section 'Impact'", "did you mean 'Speed'?"});
  expect_text_error("set title = x\n", {"scene.prm:1", "did you mean 'Title'?"});
}

TEST(SceneReader, EntryOfAnotherSectionIsSentHome)
{
  expect_scene_error({"Impact/Diameter=6 mm"},
                     {"section 'Impact'", "did you mean 'Projectile/Diameter'?"});
  expect_scene_error({"Speed=720 m/s"}, {"outside the sections", "did you mean 'Impact/Speed'?"});
}

TEST(SceneReader, UnknownSectionSuggestsTheNearestOne)
{
  expect_text_error("\nsubsection Projektile\nend\n",
                    {"scene.prm:2", "'Projektile'", "did you mean 'Projectile'?", "Contact"});
  expect_text_error("subsection Plate one\nend\n", {"did you mean 'Plate 1'?"});
}

TEST(SceneReader, OverrideDoesNotInventPlatesOrMaterials)
{
  expect_scene_error({"Plate 2/Grid spacing=1 mm"},
                     {"command line", "'Plate 2'", "did you mean 'Plate 1'?"});
  expect_scene_error({"Material PMAM/Density=1190 kg/m3"}, {"did you mean 'Material PMMA'?"});
}

TEST(SceneReader, AllMissingEntriesAreListedAtOnce)
{
  expect_text_error("subsection Plate 1\n  set Material = steel\nend\n",
                    {"scene.prm: 15 entries", "subsection Projectile\n    set Nose shape = ogive\n",
                     "set Diameter = 6.17 mm\n", "set Speed = 720 m/s\n",
                     "set Size = 200 mm, 100 mm, 30 mm\n", "subsection Material steel\n",
                     "set Final time = 450 us\n  end", "ricochet template"});
}

TEST(SceneReader, StudyIsNotAScene)
{
  expect_text_error("subsection Study\nend\n", {"scene.prm:1", "'ricochet study'"});
}

} // namespace
} // namespace ricochet::tests
