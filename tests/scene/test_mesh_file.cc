// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "ricochet/scene/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace ricochet::tests
{
namespace
{
namespace fs = std::filesystem;

const BodyOfRevolution core({NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3});

const std::string text_of_cube_in_format_41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n1\n3 1 \"body\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 0 1\n1 0 0 0 2 1 1 1 1 0\n$EndEntities\n"
    "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "0 0 0\n2 0 0\n2 1 0\n0 1 0\n0 0 1\n2 0 1\n2 1 1\n0 1 1\n$EndNodes\n"
    "$Elements\n1 1 1 1\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n";

class MeshFile : public testing::Test
{
protected:
  MeshFile() :
    path_(fs::temp_directory_path() /
          ("ricochet_" +
           std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".msh"))
  {
  }
  ~MeshFile() override { fs::remove(path_); }

  void save(const std::string &text) const { std::ofstream(path_) << text; }

  std::string text_of(const HexSolid &solid) const
  {
    std::ostringstream text;
    write_mesh(solid, core, 1e-3, text);
    return text.str();
  }

  /// The complaint about the present file.
  std::string complaint() const
  {
    try
    {
      read_mesh(path_, 1e-3);
    }
    catch (const Error &error)
    {
      return error.what();
    }
    return "";
  }

  fs::path path_;
};

TEST_F(MeshFile, IsReadAsItWasWritten)
{
  const auto solid = revolved_hexes(core, 1);
  save(text_of(solid));
  const auto read = read_mesh(path_, 1e-3);
  ASSERT_EQ(read.cells.size(), solid.cells.size());
  EXPECT_EQ(read.nodes.size(), solid.nodes.size());
  EXPECT_NEAR(volume(read), volume(solid), 1e-9 * volume(solid));
  EXPECT_LT((centroid(read) - centroid(solid)).norm(), 1e-12);
  std::vector<double> qualities[2];
  for (std::size_t cell = 0; cell < solid.cells.size(); ++cell)
  {
    qualities[0].push_back(scaled_jacobian(solid, static_cast<int>(cell)));
    qualities[1].push_back(scaled_jacobian(read, static_cast<int>(cell)));
  }
  for (auto &values : qualities)
    std::sort(values.begin(), values.end());
  for (std::size_t i = 0; i < qualities[0].size(); ++i)
    EXPECT_NEAR(qualities[0][i], qualities[1][i], 1e-8);
  EXPECT_NEAR(volume(read_mesh(path_, 25.4e-3)), std::pow(25.4, 3) * volume(solid),
              1e-9 * std::pow(25.4, 3) * volume(solid));
}

TEST_F(MeshFile, IsReadInFormat41)
{
  save(text_of_cube_in_format_41);
  const auto solid = read_mesh(path_, 1.);
  ASSERT_EQ(solid.cells.size(), 1u);
  EXPECT_NEAR(volume(solid), 2., 1e-12);
  EXPECT_NEAR(scaled_jacobian(solid, 0), 1., 1e-12);
}

TEST_F(MeshFile, OfAnotherFormatIsRefusedWithTheSettingOfARightOne)
{
  for (const char *version : {"2.2", "4.1"})
  {
    save("$MeshFormat\n" + std::string(version) + " 1 8\n\1\0\0\0\n");
    EXPECT_NE(complaint().find(version + std::string(" binary")), std::string::npos) << complaint();
    EXPECT_NE(complaint().find("Mesh.Binary = 0"), std::string::npos) << complaint();
  }
  save("$MeshFormat\n4 0 8\n$EndMeshFormat\n");
  EXPECT_NE(complaint().find("Mesh.MshFileVersion = 4.1"), std::string::npos) << complaint();
  save("$NOD\n0\n$ENDNOD\n$ELM\n0\n$ENDELM\n"); // version 1
  EXPECT_NE(complaint().find("Mesh.MshFileVersion = 4.1"), std::string::npos) << complaint();
  std::string text = text_of_cube_in_format_41;
  text.replace(text.find("3 1 0 8"), 7, "3 1 1 8");
  save(text);
  EXPECT_NE(complaint().find("Mesh.SaveParametric = 0"), std::string::npos) << complaint();
}

TEST_F(MeshFile, OfOtherElementsIsRefusedInWordsInBothFormats)
{
  const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
  const auto format_22    = [&](const std::string &element)
  {
    save("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes + "$Elements\n1\n1 " + element +
         "\n$EndElements\n");
    return complaint();
  };
  EXPECT_NE(format_22("4 2 1 1 1 2 3 4").find("1 tetrahedron"), std::string::npos) << complaint();
  EXPECT_NE(format_22("6 2 1 1 1 2 3 4 4 4").find("1 prism"), std::string::npos) << complaint();
  EXPECT_NE(format_22("11 2 1 1 1 2 3 4 1 1 1 1 1 1").find("Mesh.ElementOrder = 1"),
            std::string::npos)
      << complaint();
  EXPECT_NE(format_22("3 2 1 1 1 2 3 4").find("no volume elements"), std::string::npos)
      << complaint();

  std::string text = text_of_cube_in_format_41;
  text.replace(text.find("3 1 5 1"), 7, "3 1 12 1"); // the nodes are not looked at
  save(text);
  EXPECT_NE(complaint().find("1 second-order hexahedron"), std::string::npos) << complaint();
}

TEST_F(MeshFile, WhatCannotBeUsedIsRefusedWithOneClearMessage)
{
  EXPECT_NE(complaint().find("cannot be read"), std::string::npos) << "missing file";
  EXPECT_THROW(read_mesh(path_, 1.), FileError);

  save("solid cube\n");
  EXPECT_NE(complaint().find("does not begin with $MeshFormat"), std::string::npos);

  const std::string good = text_of(revolved_hexes(core, 1));
  save(good.substr(0, good.size() / 2));
  EXPECT_NE(complaint().find("breaks off"), std::string::npos) << complaint();

  // A cell without one of its nodes.
  const auto nodes = good.find("$EndNodes");
  save(good.substr(0, good.rfind('\n', nodes - 2) + 1) + good.substr(nodes));
  EXPECT_NE(complaint().find("cannot be used"), std::string::npos) << complaint();

  // A node pulled through its cells.
  auto folded                      = revolved_hexes(core, 1);
  folded.nodes[folded.cells[3][7]] = folded.nodes[folded.cells[3][0]] * 0.99;
  save(text_of(folded));
  EXPECT_NE(complaint().find("scaled Jacobian"), std::string::npos) << complaint();
}
} // namespace
} // namespace ricochet::tests
