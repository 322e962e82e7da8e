// SPDX-License-Identifier: LGPL-2.1-or-later
#include "projectiles/accepted_shape.h"
#include "projectiles/mesh_fit.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/geometry/revolved_hexes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace ricochet::tests
{
namespace
{
using Shape = BodyOfRevolution::Shape;

const Shape core{NoseShape::ogive, 6.17e-3, 27.6e-3, 10.23e-3},
    cylinder{NoseShape::flat, 6e-3, 15e-3, 0.}, ball{NoseShape::sphere, 6e-3, 0., 0.};

// Noses of all kinds: slender, blunt, the bluntest, and without shank.
const std::map<std::string, Shape> shapes{
    {"core", core},
    {"short ogive", {NoseShape::ogive, 4e-3, 10e-3, 5e-3}},
    {"slender ogive", {NoseShape::ogive, 6e-3, 60e-3, 30e-3}},
    {"ogive without shank", {NoseShape::ogive, 6e-3, 10e-3, 10e-3}},
    {"blunt ogive", {NoseShape::ogive, 8e-3, 12e-3, 4e-3}},
    {"cone", {NoseShape::cone, 6e-3, 20e-3, 9e-3}},
    {"slender cone", {NoseShape::cone, 6e-3, 40e-3, 35e-3}},
    {"blunt cone", {NoseShape::cone, 6e-3, 20e-3, 1e-3}},
    {"cone without shank", {NoseShape::cone, 6e-3, 4e-3, 4e-3}},
    {"hemisphere", {NoseShape::hemisphere, 6e-3, 15e-3, 0.}},
    {"long hemisphere", {NoseShape::hemisphere, 6e-3, 60e-3, 0.}},
    {"cylinder", cylinder},
    {"long cylinder", {NoseShape::flat, 6e-3, 60e-3, 0.}},
    {"ball", ball}};

HexSolid mesh_of(const Shape &shape, const int refinement = 2)
{
  return revolved_hexes(BodyOfRevolution(shape), refinement);
}

/// With its corners on the surface.
HexSolid inscribed(const Shape &shape)
{
  const BodyOfRevolution body(shape);
  HexSolid solid = revolved_hexes(body, 1);
  std::set<int> corners;
  for (const auto &quad : surface_of(solid))
    corners.insert(quad.begin(), quad.end());
  for (const int node : corners)
  {
    Vector3 &x          = solid.nodes[node];
    const double along  = std::clamp(x.x(), body.base_position(), body.tip_position()); // rounding
    const double radius = std::hypot(x.y(), x.z()), own = body.radius(along);
    const bool on_disc = radius < 0.9 * own; // inside of a flat end
    if (radius > 0. && !on_disc)
      x.tail<2>() *= own / radius;
  }
  return solid;
}

HexSolid moved(HexSolid solid, const std::function<void(Vector3 &)> &map)
{
  for (auto &x : solid.nodes)
    map(x);
  return solid;
}

/// By half a turn about the z axis.
HexSolid reversed(const HexSolid &solid)
{
  return moved(solid, [](Vector3 &x) { x.head<2>() *= -1.; });
}

/// About the x axis.
HexSolid turned(const HexSolid &solid, const double angle)
{
  const Eigen::AngleAxisd rotation(angle, Vector3::UnitX());
  return moved(solid, [&](Vector3 &x) { x = rotation * x; });
}

/// Without the hexahedra whose centre lies where.
HexSolid without(const HexSolid &solid, const std::function<bool(const Vector3 &)> &where)
{
  HexSolid rest{solid.nodes, {}};
  for (const auto &cell : solid.cells)
  {
    Vector3 centre = Vector3::Zero();
    for (const int node : cell)
      centre += solid.nodes[node] / 8.;
    if (!where(centre))
      rest.cells.push_back(cell);
  }
  EXPECT_LT(rest.cells.size(), solid.cells.size()) << "nothing was taken out";
  return rest;
}

double away(const Vector3 &x)
{
  return std::hypot(x.y(), x.z());
}

HexSolid half(const HexSolid &solid)
{
  return upper_half(solid, 1e-9);
}

/// What is said against the mesh; "" if it is accepted.
std::string complaint(const HexSolid &mesh, const Shape &shape, const bool symmetric = false)
{
  try
  {
    fitted(mesh, BodyOfRevolution(shape), symmetric);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}

void expect_complaint(const HexSolid &mesh, const Shape &shape,
                      const std::vector<std::string> &parts, const bool symmetric = false)
{
  const std::string text = complaint(mesh, shape, symmetric);
  for (const auto &part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in: " << text;
}

TEST(MeshFit, GeneratedMeshesAreAccepted)
{
  for (const auto &[name, shape] : shapes)
    for (const int refinement : {1, 2})
    {
      const HexSolid mesh = mesh_of(shape, refinement);
      EXPECT_EQ(complaint(mesh, shape), "") << name << ' ' << refinement;
      EXPECT_EQ(complaint(mesh, shape, /*symmetric=*/true), "") << name << ' ' << refinement;
      EXPECT_EQ(complaint(half(mesh), shape, /*symmetric=*/true), "") << name << ' ' << refinement;
    }
}

TEST(MeshFit, OctagonsInTheCircleAreAccepted)
{
  for (const auto &[name, shape] : shapes)
  {
    const HexSolid mesh  = inscribed(shape);
    const double section = 8. / 2. * std::sin(2. * M_PI / 8.) / M_PI; // of an octagon in a circle
    EXPECT_LT(volume(mesh), (section + 1e-3) * BodyOfRevolution(shape).volume()) << name;
    EXPECT_EQ(complaint(mesh, shape), "") << name;
    EXPECT_EQ(complaint(half(mesh), shape, /*symmetric=*/true), "") << name;
  }
}

TEST(MeshFit, IsMovedToTheBaseOfTheBodyAndAHalfToItsPlane)
{
  const BodyOfRevolution body(core);
  const auto far = [](Vector3 &x) { x += Vector3(0.2, 2e-10, 0.); };
  for (const bool is_half : {false, true})
  {
    const HexSolid mesh = is_half ? half(mesh_of(core)) : mesh_of(core);
    const HexSolid back = fitted(moved(mesh, far), body, is_half);
    ASSERT_EQ(back.nodes.size(), mesh.nodes.size());
    double low = 1., high = -1.;
    for (const auto &x : back.nodes)
    {
      low  = std::min(low, x.x());
      high = std::max(high, x.x());
      EXPECT_TRUE(!is_half || x.y() == 0. || x.y() > 1e-6);
    }
    EXPECT_NEAR(low, body.base_position(), 1e-15);
    EXPECT_NEAR(high, body.tip_position(), 1e-15); // 0.2 m lost eleven digits behind the point
  }
}

TEST(MeshFit, ATipAtTheLowerEndIsRefused)
{
  for (const auto &[name, shape] : shapes)
  {
    if (shape.nose == NoseShape::flat || shape.nose == NoseShape::sphere)
      EXPECT_EQ(complaint(reversed(mesh_of(shape, 1)), shape), "") << name << " has two equal ends";
    else
      expect_complaint(reversed(mesh_of(shape, 1)), shape,
                       {"tip at the lower end", "Turn it round"});
  }
  expect_complaint(half(reversed(mesh_of(core))), core, {"tip at the lower end"},
                   /*symmetric=*/true);
}

TEST(MeshFit, AnotherSizeOrAxisIsRefused)
{
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x *= 1e3; }), core,
                   {"2.76e+04", "27.6 mm", "6.17 mm", "Mesh unit"});
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x.x() *= 1.05; }), core, {"does not fit"});
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x.tail<2>() *= 1.08; }), core,
                   {"does not fit"});
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x.z() *= 0.9; }), core, {"does not fit"});
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x = Vector3(x.y(), x.z(), x.x()); }), core,
                   {"the x axis", "seems to be z"});
  expect_complaint(moved(mesh_of(core), [](Vector3 &x) { x = Vector3(x.z(), x.x(), x.y()); }), core,
                   {"the x axis", "seems to be y"});
}

TEST(MeshFit, AHalfIsAcceptedWhereTheSceneIsOneAndOnTheRightSide)
{
  const HexSolid upper = half(mesh_of(core));
  EXPECT_EQ(complaint(upper, core, /*symmetric=*/true), "");
  expect_complaint(upper, core, {"only its half y >= 0", "Symmetric = true"}, /*symmetric=*/false);
  for (const bool symmetric : {false, true})
  {
    expect_complaint(turned(upper, M_PI), core, {"only its part y <= 0"}, symmetric);
    expect_complaint(turned(upper, M_PI / 2.), core, {"only its part z >= 0"}, symmetric);
    expect_complaint(turned(upper, -M_PI / 2.), core, {"only its part z <= 0"}, symmetric);
    const HexSolid quarter = without(upper, [](const Vector3 &x) { return x.z() < 0.; });
    expect_complaint(half(quarter), core, {"only its part y >= 0 and z >= 0"}, symmetric);
  }
  expect_complaint(moved(upper, [](Vector3 &x) { x.y() += 5e-5; }), core, {"cut at y = 0.05 mm"},
                   /*symmetric=*/true);
}

TEST(MeshFit, AnAxisBesideTheAxisIsRefused)
{
  const double radius = core.diameter / 2.;
  for (const auto &direction : {Vector3(0., 1., 0.), Vector3(0., -0.6, 0.8)})
    for (const bool is_far : {false, true})
    {
      const HexSolid mesh = moved(mesh_of(core), [&](Vector3 &x)
                                  { x += (is_far ? 0.065 : 0.055) * radius * direction; });
      if (is_far)
        expect_complaint(mesh, core, {"has its axis at y = ", "y = z = 0"});
      else
        EXPECT_EQ(complaint(mesh, core), "");
    }
  expect_complaint(moved(half(mesh_of(core)), [](Vector3 &x) { x.z() += 1e-3; }), core,
                   {"axis at y = 0 mm, z = 1 mm"}, /*symmetric=*/true);
}

TEST(MeshFit, AnotherNoseOfTheSameLengthsIsRefused)
{
  Shape cone = core, flat = core, hemisphere = core;
  cone.nose       = NoseShape::cone;
  flat.nose       = NoseShape::flat;
  hemisphere.nose = NoseShape::hemisphere;
  const std::vector<std::string> parts{"from the base its surface lies", "Nose shape"};
  expect_complaint(mesh_of(cone), core, parts);
  expect_complaint(mesh_of(flat), core, parts);
  expect_complaint(mesh_of(hemisphere), core, parts);
  expect_complaint(mesh_of(core), cone, parts);
  expect_complaint(mesh_of(core), flat, parts);
  expect_complaint(mesh_of(core), hemisphere, parts);
  expect_complaint(mesh_of(flat), hemisphere, parts);
  expect_complaint(mesh_of(hemisphere), flat, parts);
}

TEST(MeshFit, WhatIsNotFullIsRefused)
{
  const std::vector<std::string> parts{"from the base its surface lies", "no cavities"};
  const double radius = cylinder.diameter / 2.;
  const HexSolid mesh = mesh_of(cylinder);
  // Drilled through, a cavity, and a notch.
  expect_complaint(without(mesh, [&](const Vector3 &x) { return away(x) < 0.3 * radius; }),
                   cylinder, parts);
  expect_complaint(without(mesh, [&](const Vector3 &x)
                           { return away(x) < 0.3 * radius && std::abs(x.x()) < 3e-3; }),
                   cylinder, parts);
  expect_complaint(without(mesh,
                           [&](const Vector3 &x) {
                             return away(x) > 0.8 * radius && x.y() > 0. && x.z() > 0. &&
                                    std::abs(x.x()) < 2e-3;
                           }),
                   cylinder, parts);
}

TEST(MeshFit, PiecesAndGapsAreRefused)
{
  const HexSolid mesh = mesh_of(cylinder);
  expect_complaint(without(mesh, [](const Vector3 &x) { return std::abs(x.x()) < 1e-3; }), cylinder,
                   {"falls into 2 pieces", "Coherence;"});
  // Hexahedra in front of a plane with nodes of their own on it: all of them, or a quarter.
  double plane = 0.;
  for (const auto &x : mesh.nodes)
    plane = std::abs(x.x()) < std::abs(plane) || plane == 0. ? x.x() : plane;
  for (const bool all : {true, false})
  {
    HexSolid cut = mesh;
    std::map<int, int> copies;
    for (auto &cell : cut.cells)
    {
      Vector3 centre = Vector3::Zero();
      for (const int node : cell)
        centre += mesh.nodes[node] / 8.;
      if (centre.x() < plane || (!all && (centre.y() < 0. || centre.z() < 0.)))
        continue;
      for (int &node : cell)
        if (std::abs(mesh.nodes[node].x() - plane) < 1e-9)
        {
          const auto [copy, is_new] = copies.emplace(node, static_cast<int>(cut.nodes.size()));
          if (is_new)
            cut.nodes.push_back(mesh.nodes[node]);
          node = copy->second;
        }
    }
    ASSERT_GT(copies.size(), 3u);
    const std::string coincident =
        std::to_string(copies.size()) + " nodes lie where another one lies";
    expect_complaint(cut, cylinder,
                     {all ? "falls into 2 pieces" : "has gaps", coincident, "Coherence;"});
  }
}

TEST(MeshFit, LengthsThatJustPassMayNotAddUpToAnotherVolume)
{
  const HexSolid mesh = mesh_of(cylinder, 3); // round enough for diameters at their limit
  const auto scaled   = [&](const double along, const double across)
  {
    return moved(mesh,
                 [=](Vector3 &x) { x = Vector3(along * x.x(), across * x.y(), across * x.z()); });
  };
  EXPECT_EQ(complaint(scaled(1., 1.055), cylinder), "");
  EXPECT_EQ(complaint(scaled(1.024, 1.), cylinder), "");
  expect_complaint(scaled(1.024, 1.055), cylinder, {"its volume is 483", "424.1 mm3"});
  expect_complaint(scaled(0.976, 0.945), cylinder, {"its volume is 369", "424.1 mm3"});
  expect_complaint(half(scaled(0.976, 0.945)), cylinder, {"half shape has 212.1 mm3"},
                   /*symmetric=*/true);
}

TEST(AcceptedShape, IsAsWideAsTheShapeAndAsSharpAsItsNose)
{
  const BodyOfRevolution body(core), rod({NoseShape::flat, 6e-3, 60e-3, 0.});
  const AcceptedShape accepted(body);
  EXPECT_NEAR(accepted.length_error(), 10.23e-3 / 8., 1e-12);
  EXPECT_NEAR(AcceptedShape(rod).length_error(), 3e-3 / 8., 1e-12); // not 6 % of 60 mm
  const auto [least, most] = accepted.radii(10e-3);
  EXPECT_NEAR(least, 0.92 * core.diameter / 2., 1e-12);
  EXPECT_NEAR(most, 1.15 * core.diameter / 2., 1e-12);
  EXPECT_EQ(accepted.radii(0.)[0], 0.); // the base is a disc
  EXPECT_EQ(accepted.radii(core.length)[0], 0.);
  EXPECT_NEAR(accepted.radii(core.length)[1],
              1.15 * body.radius(body.tip_position() - 10.23e-3 / 8.), 1e-12);
  EXPECT_EQ(accepted.radii(core.length + 2e-3)[1], 0.);
  const auto volumes = AcceptedShape(rod).volumes();
  EXPECT_NEAR(volumes[0], 0.94 * 0.94 * rod.volume(), 1e-6 * rod.volume());
  EXPECT_NEAR(volumes[1], 1.06 * 1.06 * rod.volume(), 1e-6 * rod.volume());
}
} // namespace
} // namespace ricochet::tests
