// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/faceted_surface.h"
#include "ricochet/geometry/revolved_hexes.h"
#include "support/hexahedra.h"

#include <gtest/gtest.h>

#include <map>

namespace ricochet::tests
{
namespace
{
struct Sample
{
  const char *name;
  BodyOfRevolution::Shape shape;
  double quality; // at refinement 2 [-]
};

const Sample samples[] = {{"Core30", {NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3}, 0.29},
                          {"Core50", {NoseShape::ogive, 10.87e-3, 47.5e-3, 18.03e-3}, 0.29},
                          {"Cone", {NoseShape::cone, 6e-3, 20e-3, 6e-3}, 0.23},
                          {"Hemisphere", {NoseShape::hemisphere, 6e-3, 20e-3, 0.}, 0.59},
                          {"Flat", {NoseShape::flat, 6e-3, 20e-3, 0.}, 0.74},
                          {"Sphere", {NoseShape::sphere, 6e-3, 0., 0.}, 0.59}};

std::vector<double> flat(const std::vector<Vector3> &nodes)
{
  std::vector<double> numbers;
  for (const auto &x : nodes)
    numbers.insert(numbers.end(), {x[0], x[1], x[2]});
  return numbers;
}

TEST(HexSolid, NaturalCoordinatesUndoTheShapeFunctions)
{
  const HexSolid solid = distorted_block({2, 2, 2}, 1e-3, 0.2);
  Random random(5);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3 natural = 1.3 * random.vector(); // outside too
    const auto N          = shape_functions(natural);
    Vector3 place         = Vector3::Zero();
    for (int a = 0; a < 8; ++a)
      place += N[a] * solid.nodes[solid.cells[i % 8][a]];
    EXPECT_LT((natural_coordinates(solid, i % 8, place) - natural).norm(), 1e-12);
  }
  EXPECT_TRUE(std::isnan(natural_coordinates(solid, 0, Vector3(1., 1., 1.)).x()));
}

TEST(RevolvedHexes, FitTheShapeWithSoundElementsAndAClosedSurface)
{
  for (const auto &sample : samples)
  {
    const BodyOfRevolution body(sample.shape);
    const auto solid = revolved_hexes(body, 2);
    double worst     = 1.;
    for (int cell = 0; cell < static_cast<int>(solid.cells.size()); ++cell)
      worst = std::min(worst, scaled_jacobian(solid, cell));
    EXPECT_GT(worst, sample.quality) << sample.name;
    EXPECT_NEAR(volume(solid), body.volume(), 2e-3 * body.volume()) << sample.name;
    EXPECT_NEAR(centroid(solid).x(), 0., 1e-3 * body.shape().length) << sample.name;
    // Closed: every edge once in each direction; volume from the surface as from the cells.
    std::map<std::pair<int, int>, int> edges;
    double enclosed = 0.;
    for (const auto &quad : surface_of(solid))
    {
      for (int a = 0; a < 4; ++a)
        ++edges[{quad[a], quad[(a + 1) % 4]}];
      const auto &x = solid.nodes;
      // Of the bilinear face: the mean of its two ways to be cut into triangles.
      for (const auto &t : {std::array<int, 3>{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}})
        enclosed += x[quad[t[0]]].dot(x[quad[t[1]]].cross(x[quad[t[2]]])) / 12.;
    }
    for (const auto &[edge, n] : edges)
    {
      EXPECT_EQ(n, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_NEAR(enclosed, volume(solid), 1e-10 * enclosed) << sample.name;
  }
}

TEST(RevolvedHexes, RefiningApproachesTheShape)
{
  const BodyOfRevolution body(samples[0].shape);
  double error[3];
  for (int refinement = 1; refinement <= 3; ++refinement)
    error[refinement - 1] = std::abs(volume(revolved_hexes(body, refinement)) / body.volume() - 1.);
  EXPECT_LT(error[1], error[0] / 3.);
  EXPECT_LT(error[2], error[1] / 3.);
  EXPECT_THROW(revolved_hexes(body, 0), InputError);
  EXPECT_THROW(revolved_hexes(body, 5), InputError);
}

TEST(HexSolid, UpperHalfHoldsHalfTheVolumeAndRefusesCellsOnBothSides)
{
  const auto solid = revolved_hexes(BodyOfRevolution(samples[0].shape), 2);
  const auto half  = upper_half(solid, 1e-9);
  EXPECT_EQ(2 * half.cells.size(), solid.cells.size());
  EXPECT_NEAR(volume(half), volume(solid) / 2., 1e-12 * volume(solid));
  for (const auto &x : half.nodes)
    EXPECT_GE(x.y(), 0.);
  EXPECT_THROW(upper_half(block({2, 3, 2}, 1., 0., {0., -1.5, 0.}), 1e-9), InputError);
}

TEST(HexSolid, ScaledJacobianFindsFoldedCells)
{
  HexSolid cube = block({1, 1, 1}, 2.);
  EXPECT_NEAR(scaled_jacobian(cube, 0), 1., 1e-15);
  EXPECT_NEAR(cell_volume(cube, 0), 8., 1e-14);
  cube.nodes[7] = Vector3(-1., -1., -1.);
  EXPECT_LT(scaled_jacobian(cube, 0), 0.);
  std::swap(cube.nodes[0], cube.nodes[1]);
  EXPECT_LT(scaled_jacobian(cube, 0), 0.);
}

TEST(FacetedSurface, DistancesAreThoseOfTheShapeUpToTheFacets)
{
  for (const auto &sample : samples)
  {
    const BodyOfRevolution body(sample.shape);
    const auto solid = revolved_hexes(body, 3);
    FacetedSurface surface(surface_of(solid));
    const double reach = 2e-3;
    surface.update(flat(solid.nodes), reach);
    Random random(9);
    int near = 0, inside = 0;
    for (int i = 0; i < 20000; ++i)
    {
      const Vector3 x(0.6 * sample.shape.length * random.uniform() + 1e-4,
                      1e-3 + 6e-3 * random.uniform(), 6e-3 * random.uniform());
      const auto exact = body.hit(x);
      FacetedSurface::Hit hit;
      const bool found = surface.hit(x, hit);
      if (std::abs(exact.distance) > reach + 2e-4)
      {
        EXPECT_FALSE(found) << sample.name << x.transpose();
      }
      else if (std::abs(exact.distance) < reach - 2e-4)
      {
        ASSERT_TRUE(found) << sample.name << ' ' << x.transpose();
        ++near;
        inside += exact.distance < 0.;
        EXPECT_NEAR(hit.distance, exact.distance, 2e-4) << sample.name << ' ' << x.transpose();
        Vector3 nearest = Vector3::Zero();
        double sum      = 0.;
        for (int a = 0; a < 4; ++a)
        {
          EXPECT_GE(hit.weights[a], -1e-12);
          nearest += hit.weights[a] * surface.node(surface.faces()[hit.face][a]);
          sum += hit.weights[a];
        }
        EXPECT_NEAR(sum, 1., 1e-12);
        EXPECT_NEAR(hit.normal.norm(), 1., 1e-9);
        EXPECT_LT((x - nearest - hit.distance * hit.normal).norm(), 1e-12);
      }
    }
    EXPECT_GT(near, 500);
    EXPECT_GT(inside, 100);
  }
}

TEST(FacetedSurface, FindsWhatASearchOfAllFacesFinds)
{
  auto solid = distorted_block({3, 4, 2}, 1e-3, 0.15);
  FacetedSurface surface(surface_of(solid)), wide(surface_of(solid));
  surface.update(flat(solid.nodes), 0.7e-3);
  wide.update(flat(solid.nodes), 1.); // one cell that holds all faces
  Random random(31);
  int found = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3 x = Vector3(1.5e-3, 2e-3, 1e-3) + 3e-3 * random.vector();
    FacetedSurface::Hit one, all;
    ASSERT_TRUE(wide.hit(x, all));
    EXPECT_EQ(surface.hit(x, one), std::abs(all.distance) <= 0.7e-3);
    if (std::abs(all.distance) > 0.7e-3)
      continue;
    ++found;
    EXPECT_NEAR(one.distance, all.distance, 1e-15);
    EXPECT_NEAR(surface.nearest(x).distance, all.distance, 1e-15);
  }
  EXPECT_GT(found, 1000);
}
} // namespace
} // namespace ricochet::tests
