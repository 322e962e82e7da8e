// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/hex_pieces.h"
#include "ricochet/geometry/revolved_hexes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ricochet::tests
{
namespace
{
using Sizes = std::vector<int>;

/// Unit cubes, the second one moved; nodes in the same place are one, or not.
HexSolid two_cubes(const std::array<int, 3> &shift, const bool merged)
{
  HexSolid solid;
  for (const int share : {0, 1})
  {
    solid.cells.push_back({});
    for (int corner = 0; corner < 8; ++corner)
    {
      Vector3 x;
      for (int d = 0; d < 3; ++d)
        x[d] = ((corner >> d) & 1) + share * shift[d];
      const auto same   = std::find(solid.nodes.begin(), solid.nodes.end(), x);
      const bool is_new = !merged || same == solid.nodes.end();
      solid.cells.back()[corner] =
          static_cast<int>(is_new ? solid.nodes.size() : same - solid.nodes.begin());
      if (is_new)
        solid.nodes.push_back(x);
    }
  }
  return solid;
}

TEST(HexPieces, AreJoinedByFacesAlone)
{
  EXPECT_EQ(piece_sizes(two_cubes({1, 0, 0}, /*merged=*/true)), Sizes{2});      // a face
  EXPECT_EQ(piece_sizes(two_cubes({1, 1, 0}, /*merged=*/true)), (Sizes{1, 1})); // an edge
  EXPECT_EQ(piece_sizes(two_cubes({1, 1, 1}, /*merged=*/true)), (Sizes{1, 1})); // a corner
  EXPECT_EQ(piece_sizes(two_cubes({3, 0, 0}, /*merged=*/true)), (Sizes{1, 1}));
  EXPECT_EQ(piece_sizes(two_cubes({1, 0, 0}, /*merged=*/false)), (Sizes{1, 1}));
  EXPECT_EQ(piece_sizes({}), Sizes{});
}

TEST(HexPieces, TheLargestIsNamedFirst)
{
  HexSolid solid = revolved_hexes(BodyOfRevolution({NoseShape::flat, 6e-3, 15e-3, 0.}), 1);
  const int n    = static_cast<int>(solid.cells.size());
  EXPECT_EQ(piece_sizes(solid), Sizes{n});
  const int first_node = static_cast<int>(solid.nodes.size());
  for (const int corner : solid.cells[0])
    solid.nodes.push_back(solid.nodes[corner] + Vector3(0.1, 0., 0.));
  solid.cells.push_back({});
  for (int corner = 0; corner < 8; ++corner)
    solid.cells.back()[corner] = first_node + corner;
  EXPECT_EQ(piece_sizes(solid), (Sizes{n, 1}));
}

TEST(HexPieces, NodesInOnePlaceAreCountedWhereverTheyLie)
{
  EXPECT_EQ(n_coincident_nodes(two_cubes({1, 0, 0}, /*merged=*/true), 1e-6), 0);
  EXPECT_EQ(n_coincident_nodes(two_cubes({1, 0, 0}, /*merged=*/false), 1e-6), 4);
  EXPECT_EQ(n_coincident_nodes(two_cubes({1, 1, 0}, /*merged=*/false), 1e-6), 2);
  // Also if they differ a little, on whatever side of the edges of a grid.
  for (const double shift : {-0.3, -1e-6, 0., 1e-7, 7.77})
    for (const double gap : {-0.9e-6, 0., 0.9e-6, 1.1e-6})
    {
      HexSolid solid = two_cubes({1, 0, 0}, /*merged=*/false);
      for (auto &x : solid.nodes)
        x += Vector3::Constant(shift);
      for (int node = 8; node < 16; ++node)
        solid.nodes[node].x() += gap;
      EXPECT_EQ(n_coincident_nodes(solid, 1e-6), gap < 1e-6 ? 4 : 0) << shift << ' ' << gap;
    }
}

TEST(HexPieces, NodesOfNoHexahedronDoNotCount)
{
  HexSolid solid = two_cubes({1, 0, 0}, /*merged=*/true);
  solid.nodes.push_back(solid.nodes[0]);
  EXPECT_EQ(n_coincident_nodes(solid, 1e-6), 0);
}
} // namespace
} // namespace ricochet::tests
