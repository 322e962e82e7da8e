// SPDX-License-Identifier: LGPL-2.1-or-later
// The sections of materials.
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
TEST(MaterialEntries, YoungsModulusAndPoissonsRatioGiveTheModuli)
{
  const Scene scene =
      read_with({"Material PMMA/Bulk modulus=", "Material PMMA/Shear modulus=",
                 "Material PMMA/Young's modulus=6 GPa", "Material PMMA/Poisson's ratio=0.2"});
  EXPECT_DOUBLE_EQ(scene.materials[0].bulk_modulus, 6e9 / 1.8);  // E / (3 (1 - 2 nu))
  EXPECT_DOUBLE_EQ(scene.materials[0].shear_modulus, 6e9 / 2.4); // E / (2 (1 + nu))
}

TEST(MaterialEntries, PoissonsRatioOfAnUnstableSolidIsRejected)
{
  for (const std::string nu : {"0.5", "-1", "0.7"})
    expect_scene_error({"Material PMMA/Bulk modulus=", "Material PMMA/Shear modulus=",
                        "Material PMMA/Young's modulus=6 GPa",
                        "Material PMMA/Poisson's ratio=" + nu},
                       {"command line", "Poisson's ratio = '" + nu + "'", "between -1 and 0.5"});
}

TEST(MaterialEntries, RelaxationSharesAndTimesMakeBranches)
{
  EXPECT_TRUE(read_with({}).materials[0].relaxation.empty());
  const Scene scene    = read_with({"Material PMMA/Relaxation shares=0.146, 0.541,0.1",
                                    "Material PMMA/Relaxation times=15.3 s, 95.4 us, 2 ms",
                                    "Material PMMA/History precision=double"});
  const auto &material = scene.materials[0];
  ASSERT_EQ(material.relaxation.size(), 3U);
  EXPECT_EQ(material.relaxation[0].share, 0.146);
  EXPECT_EQ(material.relaxation[0].time, 15.3);
  EXPECT_EQ(material.relaxation[1].share, 0.541);
  EXPECT_DOUBLE_EQ(material.relaxation[1].time, 95.4e-6);
  EXPECT_DOUBLE_EQ(material.relaxation[2].time, 2e-3);
  EXPECT_EQ(material.history_precision, HistoryPrecision::double_precision);
  EXPECT_EQ(
      read_with({"Material PMMA/Relaxation shares=0.5", "Material PMMA/Relaxation times=1 ms"})
          .materials[0]
          .relaxation.size(),
      1U);
}

TEST(MaterialEntries, IncompleteOrImpossibleRelaxationIsRejected)
{
  const std::string shares = "Material PMMA/Relaxation shares=",
                    times  = "Material PMMA/Relaxation times=";
  expect_scene_error({shares + "0.5"},
                     {"command line", "Relaxation shares = '0.5'", "no 'Relaxation times'"});
  expect_scene_error({times + "1 us"}, {"Relaxation times = '1 us'", "no 'Relaxation shares'"});
  expect_scene_error({shares + "0.5, 0.1", times + "1 us"},
                     {"2 shares, but 1 relaxation times", "as many of the one"});
  expect_scene_error({shares + "0.5, 0.5", times + "1 us, 1 ms"}, {"add up to 1", "below 1"});
  expect_scene_error({shares + "0.5, -0.1", times + "1 us, 1 ms"},
                     {"Value 2", "above 0", "one or more values"});
  expect_scene_error({shares + "0.5", times + "1"}, {"The unit is missing.", "95.4 us"});
  expect_scene_error({shares + "0.5", times + "1 us", "Material PMMA/Shear modulus=3.54 GPa",
                      "Material PMMA/Bond model=microelastic brittle"},
                     {"no shear modulus of its own", "linear peridynamic solid"});
}

TEST(MaterialEntries, FlowIsReadAndOffWithoutItsStress)
{
  EXPECT_FALSE(read_with({}).materials[0].flow.flows());
  const Scene scene =
      read_with({"Material PMMA/Flow stress=66.78 MPa", "Material PMMA/Flow rate exponent=0.06933",
                 "Material PMMA/Flow pressure coefficient=0"});
  const auto &flow = scene.materials[0].flow;
  EXPECT_TRUE(flow.flows());
  EXPECT_DOUBLE_EQ(flow.stress, 66.78e6);
  EXPECT_EQ(flow.rate_exponent, 0.06933);
  EXPECT_EQ(flow.pressure_slope, 0.);
}

TEST(MaterialEntries, IncompleteOrImpossibleFlowIsRejected)
{
  const std::string stress   = "Material PMMA/Flow stress=66.78 MPa",
                    exponent = "Material PMMA/Flow rate exponent=0.06933",
                    slope    = "Material PMMA/Flow pressure coefficient=0.223";
  expect_scene_error({stress, slope}, {"command line", "Flow stress = '66.78 MPa'",
                                       "needs 'Flow rate exponent'", "set it to 0 MPa"});
  expect_scene_error({stress, exponent},
                     {"Flow stress = '66.78 MPa'", "'Flow pressure coefficient'", "Add them"});
  // A file that includes one with flow can switch it off.
  EXPECT_FALSE(
      read_with({"Material PMMA/Flow stress=0 MPa", exponent, slope}).materials[0].flow.flows());
  expect_scene_error({stress, exponent, slope, "Material PMMA/Relaxation shares=0.5",
                      "Material PMMA/Relaxation times=1 us"},
                     {"Flow stress = '66.78 MPa'", "relaxes cannot flow", "'Relaxation shares'"});
  expect_scene_error({stress, exponent, slope, "Material PMMA/Shear modulus=3.54 GPa",
                      "Material PMMA/Bond model=microelastic brittle"},
                     {"Flow stress = '66.78 MPa'", "'microelastic brittle'",
                      "no shear modulus of its own", "linear peridynamic solid"});
  expect_scene_error({stress, "Material PMMA/Flow rate exponent=0", slope}, {"above 0"});
  expect_scene_error({stress, exponent, "Material PMMA/Flow pressure coefficient=-0.1"},
                     {"Flow pressure coefficient = '-0.1'"});
}

TEST(MaterialEntries, BrokenBondsResistCompressionUnlessTheyAreToCarryNothing)
{
  EXPECT_TRUE(read_with({}).materials[0].cracks_push);
  for (const bool push : {true, false})
    EXPECT_EQ(read_with({std::string("Material PMMA/Broken bonds=") +
                         (push ? "resist compression" : "carry nothing")})
                  .materials[0]
                  .cracks_push,
              push);
  expect_scene_error({"Material PMMA/Broken bonds=heal"},
                     {"Broken bonds = 'heal'", "resist compression", "carry nothing"});
}

TEST(MaterialEntries, BrokenBondsPartAtAQuarterOfASpacingUnlessToldOtherwise)
{
  EXPECT_EQ(read_with({}).materials[0].parting_extension, 0.25);
  EXPECT_EQ(read_with({"Material PMMA/Parting extension=0.5"}).materials[0].parting_extension, 0.5);
  expect_scene_error({"Material PMMA/Parting extension=0"}, {"Parting extension = '0'", "above 0"});
}

TEST(MaterialEntries, BondModelThatFixesPoissonsRatioNeedsFittingModuli)
{
  const std::string model = "Material PMMA/Bond model=microelastic brittle";
  expect_scene_error({model}, {"command line", "0.25", "0.330"});
  const Scene scene = read_with({model, "Material PMMA/Shear modulus=3.54 GPa"}); // 0.6 * 5.9
  EXPECT_EQ(scene.materials[0].bond_model, "microelastic brittle");
}

TEST(MaterialEntries, OnePairOfModuliIsGiven)
{
  expect_scene_error({"Material PMMA/Young's modulus=6 GPa"},
                     {"'Material PMMA/Young's modulus'", "so is 'Shear modulus'", "scene.prm:22"});
  expect_scene_error({"Material PMMA/Bulk modulus=", "Material PMMA/Shear modulus="},
                     {"2 entries", "set Bulk modulus", "set Shear modulus", "or: set Young's"});
  expect_scene_error({"Material PMMA/Shear modulus="},
                     {"missing", "set Shear modulus = 2.258 GPa"});
}

TEST(MaterialEntries, OneFractureCriterionIsGiven)
{
  expect_scene_error({"Material PMMA/Energy release rate=500 J/m2"},
                     {"command line", "'Critical stretch' (scene.prm:23)", "Keep one"});
  expect_scene_error({"Material PMMA/Critical stretch="},
                     {"set Critical stretch", "or: set Energy release rate = 500 J/m2"});
  const Scene scene =
      read_with({"Material PMMA/Critical stretch=", "Material PMMA/Energy release rate=0.5 kJ/m2"});
  EXPECT_EQ(scene.materials[0].critical_stretch, 0.);
  EXPECT_DOUBLE_EQ(scene.materials[0].energy_release, 500.);
}
} // namespace
} // namespace ricochet::tests
