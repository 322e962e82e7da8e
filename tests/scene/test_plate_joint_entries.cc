// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
Scene with_second_plate(const std::vector<std::string> &overrides, const std::string &size)
{
  const std::string plate = "subsection Plate 2\n  set Size = " + size +
                            "\n  set Grid spacing = 2 mm\n  set Material = PMMA\nend\n";
  return read_scene(
      ParameterFile::from_text(scene_text + plate, "scene.prm", parse_overrides(overrides)));
}

const std::string fitting = "20 cm, 100 mm, 20 mm"; // another thickness

TEST(PlateJointEntries, StrengthsAreReadAndShearHasThatUnderTension)
{
  const Scene none = with_second_plate({}, fitting);
  EXPECT_FALSE(none.plates[1].has_joint());
  const Scene one = with_second_plate({"Plate 2/Joint strength=20 MPa"}, fitting);
  EXPECT_FALSE(one.plates[0].has_joint());
  EXPECT_TRUE(one.plates[1].has_joint());
  EXPECT_DOUBLE_EQ(one.plates[1].joint_tension, 20e6);
  EXPECT_EQ(one.plates[1].joint_shear, 0.);
  const Scene both = with_second_plate(
      {"Plate 2/Joint strength=20 MPa", "Plate 2/Joint shear strength=35 MPa"}, fitting);
  EXPECT_DOUBLE_EQ(both.plates[1].joint_shear, 35e6);
}

TEST(PlateJointEntries, WhatCannotBeJoinedIsNamed)
{
  const auto refused = [](std::vector<std::string> overrides, const std::string &size,
                          const std::vector<std::string> &parts)
  {
    if (overrides.empty() || overrides[0].find("shear") == std::string::npos)
      overrides.push_back("Plate 2/Joint strength=20 MPa");
    expect_error([&] { with_second_plate(overrides, size); }, parts);
  };
  refused({"Plate 2/Gap=1 mm"}, fitting, {"Plate 2/Joint strength", "gap of 1 mm"});
  refused({"Plate 2/Grid spacing=1 mm"}, fitting, {"point on point", "grid spacing of 2 mm"});
  refused({"Plate 2/Horizon ratio=2"}, fitting, {"point on point", "horizon of 3"});
  refused({}, "20 cm, 96 mm, 30 mm", {"100 mm wide"});
  refused({}, "19 cm, 100 mm, 30 mm", {"200 mm long"});
  refused({"Coupling/Zone=automatic"}, fitting, {"Zone = everything"});
  refused({"Plate 2/Joint shear strength=20 MPa"}, fitting, {"Joint strength", "not joined"});
  expect_scene_error({"Plate 1/Joint strength=20 MPa"}, {"no plate above the first"});
}
} // namespace
} // namespace ricochet::tests
