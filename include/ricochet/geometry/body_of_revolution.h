// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile's shape: a cylinder with an ogive, cone, hemisphere or flat nose, or a sphere.
// Signed distance with normal and the surface hit, volume, centroid and moments of inertia. Body
// axes: x along the axis of revolution towards the tip, origin at the centroid.
#pragma once

#include "ricochet/base/vector.h"

#include <array>
#include <vector>

namespace ricochet
{
/// The generating line of the nose.
enum class NoseShape
{
  ogive, // an arc tangent to the shank
  cone,
  hemisphere,
  flat,
  sphere // all nose
};

class BodyOfRevolution
{
public:
  /// What defines the body.
  struct Shape
  {
    NoseShape nose;
    double diameter;    // [m]
    double length;      // base to tip [m]; diameter for a sphere, whatever is given
    double nose_length; // [m]; diameter/2 for a hemisphere, 0 if flat, diameter for a sphere
  };

  /// The parts of the surface.
  enum class Surface
  {
    base,
    shank,
    nose
  };

  /// What is nearest to a point.
  struct Hit
  {
    double distance; // signed, negative inside [m]
    Vector3 normal;  // outward unit vector, the gradient of the distance, body axes [-]
    Surface surface; // where the nearest point of the surface lies
  };

  /// Throws InputError if a length is not positive or the nose is longer than the body or blunter
  /// than a hemisphere (an ogive needs nose_length >= diameter/2).
  explicit BodyOfRevolution(const Shape &shape);

  /// Nearest surface point of a point given in body axes [m].
  Hit hit(const Vector3 &point) const;

  const Shape &shape() const { return shape_; }                     // as given
  double volume() const { return volume_; }                         // [m^3]
  double base_position() const { return -centroid_; }               // axial, from the centroid [m]
  double tip_position() const { return shape_.length - centroid_; } // axial, from the centroid [m]

  /// Moments of inertia of the homogeneous body about its centroid, divided by its mass: axial,
  /// transverse [m^2].
  std::array<double, 2> gyration_squared() const { return {axial_, transverse_}; }

  /// Radius of the surface at an axial position from the centroid [m]; 0 before the base and behind
  /// the tip.
  double radius(double x) const;

  /// The generating line from base centre to tip: axial position from the centroid and radius [m],
  /// n_nose points along the nose.
  std::vector<std::array<double, 2>> profile(unsigned int n_nose = 24) const;

private:
  double radius_at(double x) const; // x from the base [m]

  Shape shape_;
  double arc_radius_; // of the ogive or hemisphere [m]
  double volume_, centroid_, axial_, transverse_;
};
} // namespace ricochet
