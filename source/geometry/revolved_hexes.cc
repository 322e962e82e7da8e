// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/revolved_hexes.h"

#include "ricochet/base/exceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace ricochet
{
namespace
{
// Half width of the inner square and box in radii, and by how much their sides bulge outwards: with
// these the smallest edge, which decides the time step, is as large as it can be.
constexpr double inner = 0.4, bulge = 0.1;

/// Nodes that coincide are one.
class Builder
{
public:
  explicit Builder(const double tolerance) : tolerance_(tolerance) {}

  int node(const Vector3 &x)
  {
    std::array<long, 3> key;
    for (int d = 0; d < 3; ++d)
      key[d] = std::lround(x[d] / tolerance_);
    const auto [entry, is_new] = numbers_.emplace(key, static_cast<int>(solid_.nodes.size()));
    if (is_new)
      solid_.nodes.push_back(x);
    return entry->second;
  }

  /// A block of n[0] x n[1] x n[2] cells, `place` of its lattice coordinates.
  template <class Place>
  void block(const std::array<int, 3> &n, Place &&place)
  {
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
        {
          std::array<int, 8> cell;
          for (int a = 0; a < 8; ++a)
            cell[a] = node(place(i + (a & 1), j + ((a >> 1) & 1), k + (a >> 2)));
          solid_.cells.push_back(cell);
          if (scaled_jacobian(solid_, static_cast<int>(solid_.cells.size()) - 1) < 0.)
            for (int a = 0; a < 8; a += 2) // left-handed block
              std::swap(solid_.cells.back()[a], solid_.cells.back()[a + 1]);
        }
  }

  HexSolid take() { return std::move(solid_); }

private:
  double tolerance_;
  HexSolid solid_;
  std::map<std::array<long, 3>, int> numbers_;
};

/// A point of the inner box from (u, v, w) in [-1, 1]^3: its faces bulge towards the sphere.
Vector3 in_box(const Vector3 &u)
{
  const double furthest = u.cwiseAbs().maxCoeff();
  if (furthest == 0.)
    return Vector3::Zero();
  const Vector3 on_sphere =
      Vector3(std::tan(M_PI / 4. * u[0]), std::tan(M_PI / 4. * u[1]), std::tan(M_PI / 4. * u[2]))
          .normalized() *
      (inner * furthest);
  return (1. - bulge) * inner * u + bulge * std::sqrt(2.) * on_sphere;
}

/// A point of the blocks around the box, on the ray through the face point u (largest component
/// +-1), at the share s of the way from the box to the sphere.
Vector3 around_box(const Vector3 &u, const double s)
{
  const Vector3 on_sphere =
      Vector3(std::tan(M_PI / 4. * u[0]), std::tan(M_PI / 4. * u[1]), std::tan(M_PI / 4. * u[2]))
          .normalized();
  return (1. - s) * in_box(u) + s * on_sphere;
}
/// The nose as the image of the unit half ball x >= 0, tip towards x, in body axes.
class Nose
{
public:
  Nose(const BodyOfRevolution &body, const double length, const int n, const double widen) :
    body_(body), radius_(body.shape().diameter / 2.), length_(length),
    shoulder_(body.tip_position() - length),
    arc_((radius_ * radius_ + length * length) / (2. * radius_)),
    is_round_(body.shape().nose == NoseShape::sphere ||
              body.shape().nose == NoseShape::hemisphere || length < 1.5 * radius_),
    scales_{{0., widen}, {M_PI / 2., widen}}
  {
    fit(n, widen);
  }

  Vector3 place(const Vector3 &unit) const
  {
    const double s = unit.norm(), across = std::hypot(unit.y(), unit.z());
    if (s == 0.)
      return {shoulder_, 0., 0.};
    const double theta = polar_angle(unit);
    const double x     = is_round_ ? length_ * unit.x() / s : length_ * (1. - 2. * theta / M_PI);
    const double r     = across == 0. ? 0. : s * scale(theta) * profile(x) / across;
    return {shoulder_ + s * x, r * unit.y(), r * unit.z()};
  }
  double shoulder() const { return shoulder_; }

private:
  static double polar_angle(const Vector3 &unit)
  {
    return std::atan2(std::hypot(unit.y(), unit.z()), unit.x());
  }

  double profile(const double x) const // radius at the distance x from the shoulder
  {
    if (body_.shape().nose == NoseShape::cone)
      return radius_ * std::max(0., 1. - x / length_);
    return std::max(0., std::sqrt(std::max(0., arc_ * arc_ - x * x)) + radius_ - arc_);
  }

  double scale(const double theta) const // of radii
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

  /// Nodes on the surface would make a slimmer body: scales radii until the facets lie as far
  /// outside the shape as inside, on an average around each node.
  void fit(const int n, const double widen)
  {
    std::vector<std::array<Vector3, 4>>
        quads; // on the unit sphere: the cap and a quarter of the sides
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

    const auto key = [](const double theta) { return std::lround(1e9 * theta); };
    std::map<long, std::pair<double, double>> error; // sums of weights times distances, of weights
    for (const auto &quad : quads)
      for (const auto &unit : quad)
        error[key(polar_angle(unit))] = {0., 0.};
    for (int iteration = 0; iteration < 20; ++iteration)
    {
      for (auto &entry : error)
        entry.second = {0., 0.};
      for (const auto &quad : quads)
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
              auto &sum = error[key(polar_angle(quad[c]))];
              sum.first += weight * distance;
              sum.second += weight;
            }
          }
      }
      std::map<double, double> better{{M_PI / 2., widen}};
      for (const auto &[number, sum] : error)
      {
        const double theta = 1e-9 * double(number);
        if (number == 0 || theta > M_PI / 2. - 1e-6) // the tip stays, the shoulder is the shank's
          continue;
        const double x = is_round_ ? length_ * std::cos(theta) : length_ * (1. - 2. * theta / M_PI);
        better[theta]  = scale(theta) - sum.first / sum.second / profile(x);
      }
      better[0.] = better.begin()->second;
      scales_    = better;
    }
  }

  const BodyOfRevolution &body_;
  double radius_, length_, shoulder_, arc_;
  bool is_round_;
  std::map<double, double> scales_; // over the polar angle
};
} // namespace

HexSolid revolved_hexes(const BodyOfRevolution &body, const int refinement)
{
  if (refinement < 1 || refinement > 4)
    throw InputError("The refinement of the projectile's mesh is " + std::to_string(refinement) +
                     "; it must lie between 1 and 4.");
  const auto &shape    = body.shape();
  const double radius  = shape.diameter / 2.;
  const int n          = 1 << refinement; // across the inner square
  const int m          = n / 2;           // from the square to the circumference
  const bool is_sphere = shape.nose == NoseShape::sphere;
  const double length  = is_sphere ? radius : shape.nose_length;
  const double shank   = shape.length - (is_sphere ? 2. : 1.) * length;

  // The polygon of 4 n edges gets the area of its circle.
  const double widen = std::sqrt(2. * M_PI / (4. * n) / std::sin(2. * M_PI / (4. * n)));

  Builder builder(1e-7 * shape.diameter);
  const auto coordinate = [&](const int i) { return 2. * i / n - 1.; };
  const auto all_around = [&](auto &&add) // the four sides of the square: (y, z) along each
  {
    for (const double sign : {-1., 1.})
    {
      add([sign](const double along) { return std::pair(sign, along); });
      add([sign](const double along) { return std::pair(along, sign); });
    }
  };

  if (length > 0.)
  {
    const Nose nose(body, length, n, widen);
    for (const double end : is_sphere ? std::vector<double>{1., -1.} : std::vector<double>{1.})
    {
      const auto place = [&](const Vector3 &unit)
      {
        Vector3 x = nose.place(unit);
        x.x()     = nose.shoulder() + end * (x.x() - nose.shoulder());
        return x;
      };
      builder.block({n, n, n},
                    [&](const int i, const int j, const int k) {
                      return place(in_box({double(i) / n, coordinate(j), coordinate(k)}));
                    });
      builder.block({m, n, n},
                    [&](const int i, const int j, const int k) {
                      return place(around_box({1., coordinate(j), coordinate(k)}, double(i) / m));
                    });
      all_around(
          [&](auto &&side)
          {
            builder.block({n, n, m},
                          [&](const int i, const int j, const int k)
                          {
                            const auto [y, z] = side(coordinate(j));
                            return place(around_box({double(i) / n, y, z}, double(k) / m));
                          });
          });
    }
  }
  if (shank > 0.)
  {
    // A third longer than the cells of the square are wide.
    const int layers =
        std::max(1, static_cast<int>(std::lround(0.75 * shank * n / (2. * inner * radius))));
    const auto place = [&](const int i, const Vector3 &unit)
    {
      return Vector3(body.base_position() + shank * i / layers, widen * radius * unit.y(),
                     widen * radius * unit.z());
    };
    builder.block({layers, n, n},
                  [&](const int i, const int j, const int k) {
                    return place(i, in_box({0., coordinate(j), coordinate(k)}));
                  });
    all_around(
        [&](auto &&side)
        {
          builder.block({layers, n, m},
                        [&](const int i, const int j, const int k)
                        {
                          const auto [y, z] = side(coordinate(j));
                          return place(i, around_box({0., y, z}, double(k) / m));
                        });
        });
  }

  HexSolid solid = builder.take();
  for (auto &x : solid.nodes)
    for (int d = 1; d < 3; ++d)
      if (std::abs(x[d]) < 1e-7 * shape.diameter)
        x[d] = 0.;
  return solid;
}
} // namespace ricochet
