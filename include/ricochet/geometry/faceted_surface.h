// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a deforming body: quadrilaterals, each four flat triangles that meet in the mean
// of its corners, so that the nearest point is found exactly, without iteration, and is a fixed
// weighted mean of the corners. Nearby faces come from a uniform grid.
#pragma once

#include "ricochet/geometry/hex_solid.h"

namespace ricochet
{
class FacetedSurface
{
public:
  /// What is nearest to a point.
  struct Hit
  {
    double distance;               // signed, negative inside [m]
    Vector3 normal;                // outward unit vector, the gradient of the distance [-]
    int face;                      // number of the face with the nearest point
    std::array<double, 4> weights; // the nearest point is the sum of these times the corners [-]
  };

  /// The faces by their nodes, each counter-clockwise seen from outside; update() places them.
  explicit FacetedSurface(const std::vector<SurfaceQuad> &faces) : faces_(faces) {}

  /// Takes over the nodes' positions, three numbers each [m]; afterwards hit() finds what is nearer
  /// than `reach` [m]. Copies the positions.
  void update(const std::vector<double> &position, double reach);

  /// The nearest point of the surface; false if it is farther away than the reach, inside or out.
  bool hit(const Vector3 &point, Hit &hit) const;
  /// The same at any distance, by a search of all faces.
  Hit nearest(const Vector3 &point) const;

  const std::vector<SurfaceQuad> &faces() const { return faces_; } // as given
  /// Position of a node at the last update() [m].
  Vector3 node(const int number) const
  {
    return Eigen::Map<const Vector3>(position_.data() + 3 * number);
  }
  /// Corners of a box around the surface [m].
  std::pair<Vector3, Vector3> bounding_box() const { return {low_, high_}; }

private:
  struct Sphere
  {
    Vector3 centre;
    double radius;
  };

  bool improve(int face, const Vector3 &point, double &squared, double &cosine, Hit &hit) const;

  std::vector<SurfaceQuad> faces_;
  std::vector<double> position_;
  std::vector<Sphere> spheres_; // around each face
  Vector3 low_, high_;
  double reach_ = 0., cell_ = 1.;
  std::array<int, 3> n_{0, 0, 0};
  std::vector<int> starts_, entries_; // of each cell of the grid: the faces within reach of it
};
} // namespace ricochet
