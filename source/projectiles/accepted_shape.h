// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a mesh may be from the body of revolution that it stands for. The coarsest mesh that is
// meant has eight edges around the axis and two layers in the nose. If its corners lie on the
// shape, its flats are cos(pi/8) = 0.924 radii from the axis and its section has 0.900 of the
// circle's area; if it has the circle's area, its corners are 1.054 radii from the axis. In the
// nose the layers add their own: the generated mesh of that kind, which gives back the volume, has
// corners up to 1.144 times the radius of the shape an eighth of the nose away. The tests hold
// these limits against both kinds of mesh, for noses of all kinds.
#pragma once

#include "ricochet/geometry/body_of_revolution.h"

namespace ricochet
{
class AcceptedShape
{
public:
  /// Of diameter and length, and of the axis' place in radii, may be missed [-].
  static constexpr double most_error = 0.06;

  /// `body` must outlive this object.
  explicit AcceptedShape(const BodyOfRevolution &body) : body_(body) {}

  /// By which the length may differ [m]: a tip that is cut off may not take away more of the nose
  /// than a layer of the coarsest mesh rounds off.
  double length_error() const;

  /// Where the surface may lie at a distance x from the base: least and largest distance from the
  /// axis [m].
  std::array<double, 2> radii(double x) const;

  /// Least and largest volume of the whole body [m^3].
  std::array<double, 2> volumes() const;

private:
  double reach() const; // along the axis [m]

  const BodyOfRevolution &body_;
};
} // namespace ricochet
