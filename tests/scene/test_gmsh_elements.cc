// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/gmsh_elements.h"

#include "ricochet/base/exceptions.h"

#include <gtest/gtest.h>

#include <vector>

namespace ricochet::tests
{
namespace
{
// Types of elements, from the chapter on file formats of gmsh's manual.
constexpr int line = 1, triangle = 2, quadrangle = 3, tetrahedron = 4, hexahedron = 5, prism = 6,
              pyramid = 7, line_3 = 8, quadrangle_9 = 10, tetrahedron_10 = 11, hexahedron_27 = 12,
              prism_18 = 13, pyramid_14 = 14, point = 15, hexahedron_20 = 17, hexahedron_64 = 92,
              unheard_of = 777;

/// What is said of a mesh with these elements; "" if it is accepted.
std::string complaint(const GmshElementCounts &counts)
{
  try
  {
    require_hexahedra("body.msh", counts);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}

void expect_complaint(const GmshElementCounts &counts, const std::vector<std::string> &parts)
{
  const std::string text = complaint(counts);
  for (const auto &part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in: " << text;
  EXPECT_EQ(text.rfind("body.msh: ", 0), 0u) << text;
  EXPECT_EQ(text.find("deal.II"), std::string::npos) << text;
}

TEST(GmshElements, AreCountedInFormat22)
{
  // Tags may be any number, and what stands in other sections is none of them.
  const auto counts = count_elements(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 5 \"5 5 5\"\n$EndPhysicalNames\n"
      "$Nodes\n1\n1 5 5 5\n$EndNodes\n$Elements\n5\n1 15 2 0 1 1\n2 3 2 1 1 1 2 3 4\n"
      "3 5 2 1 1 1 2 3 4 5 6 7 8\n4 5 4 1 1 1 1 1 2 3 4 5 6 7 8\n5 12 0 1 2 3\n$EndElements\n"
      "$NodeData\n6 5\n7 5\n$EndNodeData\n");
  EXPECT_EQ(counts,
            (GmshElementCounts{{point, 1}, {quadrangle, 1}, {hexahedron, 2}, {hexahedron_27, 1}}));
}

TEST(GmshElements, AreCountedInFormat41)
{
  const auto counts =
      count_elements("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Elements\n3 4 1 4\n0 1 15 1\n1 1\n"
                     "2 1 3 1\n2 1 2 3 4\n3 1 5 2\n3 1 2 3 4 5 6 7 8\n4 1 2 3 4 5 6 7 8\n"
                     "$EndElements\n");
  EXPECT_EQ(counts, (GmshElementCounts{{point, 1}, {quadrangle, 1}, {hexahedron, 2}}));
}

TEST(GmshElements, OfAFileThatBreaksOffAreThoseBeforeTheBreak)
{
  EXPECT_EQ(count_elements(""), GmshElementCounts{});
  EXPECT_EQ(count_elements("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n3\n1 5 2 1"),
            (GmshElementCounts{{hexahedron, 1}}));
  EXPECT_EQ(
      count_elements("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Elements\n2 9 1 9\n3 1 5 8\n1 1"),
      (GmshElementCounts{{hexahedron, 8}}));
  EXPECT_EQ(count_elements("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Elements\n9 9 1 9\n"),
            GmshElementCounts{});
}

TEST(GmshElements, HexahedraAndWhatBoundsThemAreAccepted)
{
  EXPECT_EQ(complaint({{hexahedron, 8}}), "");
  EXPECT_EQ(complaint({{point, 8}, {line, 12}, {quadrangle, 24}, {hexahedron, 8}}), "");
}

TEST(GmshElements, OfSecondOrderAreNamedWithTheSettingOfFirst)
{
  expect_complaint({{line_3, 9}, {quadrangle_9, 6}, {hexahedron_27, 192}},
                   {"192 second-order hexahedra", "8 nodes", "Mesh.ElementOrder = 1"});
  expect_complaint({{hexahedron_20, 1}}, {"1 second-order hexahedron", "Mesh.ElementOrder = 1"});
  expect_complaint({{hexahedron_64, 7}}, {"7 hexahedra of higher order", "Mesh.ElementOrder = 1"});
  // Their shape is right, so nothing is said of other shapes.
  EXPECT_EQ(complaint({{hexahedron_27, 1}}).find("Recombine"), std::string::npos);
}

TEST(GmshElements, OfAnotherShapeAreNamedWithTheSettingsThatMakeHexahedra)
{
  expect_complaint({{triangle, 12}, {tetrahedron, 408}},
                   {"408 tetrahedra", "Mesh.SubdivisionAlgorithm = 2", "Mesh.RecombineAll = 1"});
  expect_complaint({{triangle, 2}, {quadrangle, 9}, {prism, 288}},
                   {"288 prisms", "'Recombine'", "Mesh.RecombineAll = 1"});
  expect_complaint({{pyramid, 1}, {hexahedron, 5}}, {"1 pyramid", "5 hexahedra", "Recombine"});
  EXPECT_EQ(complaint({{tetrahedron, 1}}).find("ElementOrder"), std::string::npos);
}

TEST(GmshElements, OfSeveralKindsAreAllCounted)
{
  expect_complaint({{hexahedron, 8}, {tetrahedron, 408}, {pyramid, 4}},
                   {"408 tetrahedra, 8 hexahedra and 4 pyramids"});
  expect_complaint(
      {{tetrahedron_10, 30}, {prism_18, 20}, {pyramid_14, 10}},
      {"30 second-order tetrahedra, 20 second-order prisms and 10 second-order pyramids",
       "Mesh.ElementOrder = 1", "Mesh.SubdivisionAlgorithm = 2"});
  expect_complaint({{hexahedron, 3}, {unheard_of, 2}}, {"2 elements of gmsh's type 777"});
}

TEST(GmshElements, WithoutVolumesNameWhatIsThere)
{
  expect_complaint({{line, 56}, {quadrangle, 160}},
                   {"no volume elements", "160 quadrangles", "56 lines", "Mesh.SaveAll = 1"});
  expect_complaint({}, {"no volume elements", "Mesh.SaveAll = 1"});
}

TEST(GmshElements, TrianglesBoundNoHexahedra)
{
  expect_complaint({{triangle, 12}, {hexahedron, 8}}, {"12 triangles", "Mesh.RecombineAll = 1"});
}

TEST(GmshElements, ParametersOfNodesAreSeen)
{
  const std::string head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 3 1 3\n";
  EXPECT_FALSE(has_parametric_nodes(head + "0 1 0 1\n1\n1 1 1\n3 1 0 2\n2\n3\n0 0 0\n1 1 1\n"));
  EXPECT_TRUE(has_parametric_nodes(head + "0 1 0 1\n1\n1 1 1\n1 1 1 2\n2\n3\n0 0 0 1\n1 1 1 2\n"));
  EXPECT_FALSE(has_parametric_nodes("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 1 1 1\n"));
  EXPECT_TRUE(has_parametric_nodes(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n1\n1 1 1 1 1 1 0.5\n"));
}
} // namespace
} // namespace ricochet::tests
