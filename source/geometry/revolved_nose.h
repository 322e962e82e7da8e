// SPDX-License-Identifier: LGPL-2.1-or-later
// The nose of a body of revolution as the image of the unit half ball x >= 0, tip towards x, in
// body axes.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/geometry/body_of_revolution.h"

#include <array>
#include <map>
#include <utility>

namespace ricochet
{
class RevolvedNose
{
public:
  /// `length` of the nose [m]; n cells across the inner square. Where the shank begins radii are
  /// enlarged by the factor `widen`. `body` must outlive this object.
  RevolvedNose(const BodyOfRevolution &body, double length, int n, double widen);

  /// Of a point of the half ball [m].
  Vector3 place(const Vector3 &unit) const;
  double shoulder() const { return shoulder_; } // x at its base [m]

private:
  using Quad   = std::array<Vector3, 4>; // a facet's corners, on the unit sphere
  /// Sums of weights times distances from the shape [m^3] and of weights [m^2], over the polar
  /// angle in nanoradians.
  using Errors = std::map<long, std::pair<double, double>>;

  double axial(double theta) const; // from the shoulder [m]
  double profile(double x) const;   // radius at the distance x from the shoulder [m]
  double scale(double theta) const; // of radii [-]
  void fit(int n, double widen);
  void add_errors(const Quad &quad, Errors &errors) const;
  void correct(const Errors &errors, double widen);

  const BodyOfRevolution &body_;
  double radius_, length_, shoulder_, arc_; // [m]
  bool is_round_;
  std::map<double, double> scales_; // over the polar angle
};
} // namespace ricochet
