// SPDX-License-Identifier: LGPL-2.1-or-later
#include "revolved_nose.h"

#include "unit_ball.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace ricochet
{
namespace
{
double polar_angle(const Vector3 &unit)
{
  return std::atan2(std::hypot(unit.y(), unit.z()), unit.x());
}

/// Angles that differ by rounding are one.
long nanoradians(const double theta)
{
  return std::lround(1e9 * theta);
}

/// Facets on the unit sphere: the cap and a quarter of the sides.
std::vector<std::array<Vector3, 4>> facets(const int n)
{
  std::vector<std::array<Vector3, 4>> quads;
  const auto add = [&](auto &&face)
  {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
      {
        std::array<Vector3, 4> quad;
        const int corner[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
        for (int a = 0; a < 4; ++a)
          quad[a] = around_box(face(corner[a][0], corner[a][1]), 1.);
        quads.push_back(quad);
      }
  };
  const auto coordinate = [&](const int i) { return 2. * i / n - 1.; };
  add([&](const int i, const int j) { return Vector3(1., coordinate(i), coordinate(j)); });
  add([&](const int i, const int j) { return Vector3(double(i) / n, 1., coordinate(j)); });
  return quads;
}
} // namespace

RevolvedNose::RevolvedNose(const BodyOfRevolution &body, const double length, const int n,
                           const double widen) :
  body_(body),
  radius_(body.shape().diameter / 2.), length_(length), shoulder_(body.tip_position() - length),
  arc_((radius_ * radius_ + length * length) / (2. * radius_)),
  is_round_(body.shape().nose == NoseShape::sphere || body.shape().nose == NoseShape::hemisphere ||
            length < 1.5 * radius_),
  scales_{{0., widen}, {M_PI / 2., widen}}
{
  fit(n, widen);
}

Vector3 RevolvedNose::place(const Vector3 &unit) const
{
  const double s = unit.norm(), across = std::hypot(unit.y(), unit.z());
  if (s == 0.)
    return {shoulder_, 0., 0.};
  const double theta = polar_angle(unit);
  const double x     = is_round_ ? length_ * unit.x() / s : length_ * (1. - 2. * theta / M_PI);
  const double r     = across == 0. ? 0. : s * scale(theta) * profile(x) / across;
  return {shoulder_ + s * x, r * unit.y(), r * unit.z()};
}

double RevolvedNose::axial(const double theta) const
{
  return is_round_ ? length_ * std::cos(theta) : length_ * (1. - 2. * theta / M_PI);
}

double RevolvedNose::profile(const double x) const
{
  if (body_.shape().nose == NoseShape::cone)
    return radius_ * std::max(0., 1. - x / length_);
  return std::max(0., std::sqrt(std::max(0., arc_ * arc_ - x * x)) + radius_ - arc_);
}

double RevolvedNose::scale(const double theta) const
{
  const auto above = scales_.lower_bound(theta);
  if (above == scales_.begin())
    return above->second;
  if (above == scales_.end())
    return scales_.rbegin()->second;
  const auto below   = std::prev(above);
  const double share = (theta - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

/// Nodes on the surface would make a slimmer body: scales radii until the facets lie as far outside
/// the shape as inside, on an average around each node.
void RevolvedNose::fit(const int n, const double widen)
{
  const auto quads = facets(n);
  for (int iteration = 0; iteration < 20; ++iteration)
  {
    Errors errors;
    for (const auto &quad : quads)
      add_errors(quad, errors);
    correct(errors, widen);
  }
}

void RevolvedNose::add_errors(const Quad &quad, Errors &errors) const
{
  Vector3 corner[4], mean = Vector3::Zero();
  for (int a = 0; a < 4; ++a)
  {
    corner[a] = place(quad[a]);
    mean += 0.25 * corner[a];
  }
  // The four triangles of contact/surface_contact.h, three points in each.
  for (int a = 0; a < 4; ++a)
    for (int point = 0; point < 3; ++point)
    {
      const int b       = (a + 1) % 4;
      double share[3]   = {1. / 6., 1. / 6., 1. / 6.};
      share[point]      = 2. / 3.;
      const double area = (corner[b] - corner[a]).cross(mean - corner[a]).norm();
      const double distance =
          body_.hit(share[0] * corner[a] + share[1] * corner[b] + share[2] * mean).distance;
      for (int c = 0; c < 4; ++c)
      {
        const double weight =
            area * (0.25 * share[2] + (c == a ? share[0] : 0.) + (c == b ? share[1] : 0.));
        auto &sum = errors[nanoradians(polar_angle(quad[c]))];
        sum.first += weight * distance;
        sum.second += weight;
      }
    }
}

void RevolvedNose::correct(const Errors &errors, const double widen)
{
  std::map<double, double> better{{M_PI / 2., widen}};
  for (const auto &[number, sum] : errors)
  {
    const double theta = 1e-9 * double(number);
    if (number == 0 || theta > M_PI / 2. - 1e-6) // the tip stays, the shoulder is the shank's
      continue;
    better[theta] = scale(theta) - sum.first / sum.second / profile(axial(theta));
  }
  better[0.] = better.begin()->second;
  scales_    = better;
}
} // namespace ricochet
