// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/body_of_revolution.h"

#include "ricochet/base/exceptions.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
using Vector2 = Eigen::Vector2d; // axial position from the base, radius

struct Candidate
{
  Vector2 nearest; // point of the generating line
  Vector2 normal;  // outward, of the line itself
};

Candidate nearest_on_segment(const Vector2 &a, const Vector2 &b, const Vector2 &p)
{
  // The line runs from base to tip, so the outside is to its left.
  const Vector2 d = b - a;
  const double t  = std::clamp((p - a).dot(d) / d.squaredNorm(), 0., 1.);
  return {a + t * d, Vector2(-d.y(), d.x()).normalized()};
}

Candidate nearest_on_arc(const Vector2 &center, const double radius, const Vector2 &shoulder,
                         const Vector2 &tip, const Vector2 &p)
{
  const Vector2 n  = p == center ? Vector2(0., 1.) : Vector2((p - center).normalized());
  const Vector2 a  = (shoulder - center).normalized();
  const Vector2 b  = (tip - center).normalized();
  const auto cross = [](const Vector2 &u, const Vector2 &v)
  { return u.x() * v.y() - u.y() * v.x(); };
  if (cross(n, a) >= 0. && cross(b, n) >= 0.)
    return {center + radius * n, n};
  return (p - shoulder).squaredNorm() < (p - tip).squaredNorm() ? Candidate{shoulder, a}
                                                                : Candidate{tip, b};
}
} // namespace

BodyOfRevolution::BodyOfRevolution(const Shape &shape) : shape_(shape)
{
  const double radius = shape.diameter / 2.;
  if (shape.nose == NoseShape::sphere)
    shape_.length = shape_.nose_length = shape.diameter;
  if (!(radius > 0.) || !(shape_.length > 0.))
    throw InputError("The projectile's diameter and length must be positive; they are " +
                     std::to_string(shape.diameter * 1e3) + " mm and " +
                     std::to_string(shape_.length * 1e3) + " mm.");
  if (shape.nose == NoseShape::flat)
    shape_.nose_length = 0.;
  if (shape.nose == NoseShape::hemisphere)
    shape_.nose_length = radius;
  if (shape_.nose_length > shape_.length)
    throw InputError("The projectile's nose (" + std::to_string(shape_.nose_length * 1e3) +
                     " mm) is longer than the projectile (" + std::to_string(shape.length * 1e3) +
                     " mm).");
  if (shape.nose == NoseShape::ogive && shape_.nose_length < radius * (1. - 1e-9))
    throw InputError("A tangent ogive is at least as long as its radius (" +
                     std::to_string(radius * 1e3) + " mm); the nose length is " +
                     std::to_string(shape_.nose_length * 1e3) + " mm.");
  if (shape.nose == NoseShape::cone && !(shape_.nose_length > 0.))
    throw InputError("A cone needs a positive nose length.");

  const double l = shape_.nose_length;
  arc_radius_    = (radius * radius + l * l) / (2. * radius);

  // Slices along the axis: dV = pi r^2 dx, inertia of a disc. Simpson's rule, separately on shank
  // and nose, is exact for shank and cone and converges fast for the arc.
  double volume = 0., first = 0., second = 0., fourth = 0.;
  const auto add = [&](const double a, const double b, const int n)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x  = a + (b - a) * i / n;
      const double w  = (i == 0 || i == n ? 1. : (i % 2 ? 4. : 2.)) * (b - a) / (3. * n) * M_PI;
      const double r2 = std::pow(radius_at(x), 2);
      volume += w * r2;
      first += w * r2 * x;
      second += w * r2 * x * x;
      fourth += w * r2 * r2;
    }
  };
  const double shoulder = shape_.length - l;
  if (shoulder > 0.)
    add(0., shoulder, 2);
  if (l > 0.)
    add(shoulder, shape_.length, 4000);

  volume_     = volume;
  centroid_   = first / volume;
  axial_      = fourth / volume / 2.;
  transverse_ = fourth / volume / 4. + second / volume - centroid_ * centroid_;
}

double BodyOfRevolution::radius_at(const double x) const
{
  const double radius = shape_.diameter / 2.;
  if (shape_.nose == NoseShape::sphere)
    return std::sqrt(std::max(0., x * (shape_.diameter - x)));
  const double s = x - (shape_.length - shape_.nose_length); // behind the shoulder if negative
  if (s <= 0.)
    return radius;
  if (shape_.nose == NoseShape::cone)
    return radius * std::max(0., 1. - s / shape_.nose_length);
  return std::max(0., std::sqrt(std::max(0., arc_radius_ * arc_radius_ - s * s)) + radius -
                          arc_radius_);
}

BodyOfRevolution::Hit BodyOfRevolution::hit(const Vector3 &point) const
{
  if (shape_.nose == NoseShape::sphere)
  {
    const double r = point.norm();
    return {r - shape_.diameter / 2., r > 0. ? Vector3(point / r) : Vector3(Vector3::UnitX()),
            Surface::nose};
  }
  const double radius   = shape_.diameter / 2.;
  const double shoulder = shape_.length - shape_.nose_length;
  const double r        = std::hypot(point.y(), point.z());
  const Vector2 p(point.x() + centroid_, r);

  double best_squared = std::numeric_limits<double>::max();
  Candidate best{};
  Surface surface     = Surface::base;
  const auto consider = [&](const Candidate &candidate, const Surface which)
  {
    const double squared = (p - candidate.nearest).squaredNorm();
    if (squared < best_squared)
    {
      best_squared = squared;
      best         = candidate;
      surface      = which;
    }
  };
  const Vector2 edge(shoulder, radius), tip(shape_.length, 0.);
  if (shoulder > 0.)
    consider(nearest_on_segment({0., radius}, edge, p), Surface::shank);
  if (shape_.nose == NoseShape::ogive || shape_.nose == NoseShape::hemisphere)
    consider(nearest_on_arc({shoulder, radius - arc_radius_}, arc_radius_, edge, tip, p),
             Surface::nose);
  else
    consider(nearest_on_segment(edge, tip, p), Surface::nose);
  consider(nearest_on_segment({0., 0.}, {0., radius}, p), Surface::base);

  const bool inside     = p.x() >= 0. && p.x() <= shape_.length && r <= radius_at(p.x());
  const double distance = std::sqrt(best_squared);
  // Beside an edge or the tip the gradient of the distance points away from that edge; on the line
  // itself (and closer to it than rounding resolves) it is the line's own normal.
  Vector2 n             = best.normal;
  if (distance > 1e-9 * shape_.diameter)
    n = (inside ? best.nearest - p : p - best.nearest) / distance;
  const double c = r > 0. ? point.y() / r : 0., s = r > 0. ? point.z() / r : 1.;
  return {inside ? -distance : distance, Vector3(n.x(), n.y() * c, n.y() * s), surface};
}

double BodyOfRevolution::radius(const double x) const
{
  return x < base_position() || x > tip_position() ? 0. : radius_at(x + centroid_);
}

std::vector<std::array<double, 2>> BodyOfRevolution::profile(const unsigned int n_nose) const
{
  if (shape_.nose == NoseShape::sphere)
  {
    std::vector<std::array<double, 2>> circle{{base_position(), 0.}};
    for (unsigned int i = 1; i < n_nose; ++i)
      circle.push_back({-shape_.diameter / 2. * std::cos(M_PI * i / n_nose),
                        shape_.diameter / 2. * std::sin(M_PI * i / n_nose)});
    circle.push_back({tip_position(), 0.});
    return circle;
  }
  std::vector<std::array<double, 2>> line{{-centroid_, 0.}, {-centroid_, shape_.diameter / 2.}};
  const double shoulder = shape_.length - shape_.nose_length;
  if (shape_.nose == NoseShape::flat)
  {
    line.push_back({tip_position(), shape_.diameter / 2.});
    line.push_back({tip_position(), 0.});
    return line;
  }
  for (unsigned int i = 0; i <= n_nose; ++i)
  {
    // Cosine spacing refines towards the tip, where a hemisphere's profile is steep.
    const double x = shoulder + shape_.nose_length * std::sin(M_PI / 2. * i / n_nose);
    line.push_back({x - centroid_, i == n_nose ? 0. : radius_at(x)});
  }
  return line;
}
} // namespace ricochet
