// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/revolved_hexes.h"

#include "ricochet/base/exceptions.h"

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
} // namespace

HexSolid revolved_hexes(const BodyOfRevolution &body, const int refinement)
{
  if (refinement < 1 || refinement > 5)
    throw InputError("The refinement of the projectile's mesh is " + std::to_string(refinement) +
                     "; it must lie between 1 and 5.");
  const auto &shape    = body.shape();
  const double radius  = shape.diameter / 2.;
  const int n          = 1 << refinement; // across the inner square
  const int m          = n / 2;           // from the square to the circumference
  const bool is_sphere = shape.nose == NoseShape::sphere;
  const double nose = is_sphere ? radius : shape.nose_length, shank = shape.length - (is_sphere ? 2. : 1.) * nose;
  const double shoulder = body.tip_position() - nose;
  const bool is_round =
      is_sphere || shape.nose == NoseShape::hemisphere || nose < 1.5 * radius;

  // The polygon of 4 n edges gets the area of its circle.
  const double widen = std::sqrt(2. * M_PI / (4. * n) / std::sin(2. * M_PI / (4. * n)));
  const double arc   = (radius * radius + nose * nose) / (2. * radius);
  const auto profile = [&](const double x) // radius at the distance x from the shoulder
  {
    if (shape.nose == NoseShape::cone)
      return radius * std::max(0., 1. - x / nose);
    return std::max(0., std::sqrt(std::max(0., arc * arc - x * x)) + radius - arc);
  };
  const auto nose_point = [&](const Vector3 &unit) // of the half ball of radius 1, x >= 0
  {
    const double s = unit.norm(), across = std::hypot(unit.y(), unit.z());
    if (s == 0.)
      return Vector3(shoulder, 0., 0.);
    const double theta = std::atan2(across, unit.x());
    const double x     = is_round ? nose * unit.x() / s : nose * (1. - 2. * theta / M_PI);
    const double r     = across == 0. ? 0. : s * profile(x) / across;
    return Vector3(shoulder + s * x, r * unit.y(), r * unit.z());
  };

  Builder builder(1e-7 * shape.diameter);
  const auto coordinate = [&](const int i) { return 2. * i / n - 1.; };
  const auto all_around = [&](auto &&add) // the four sides of the square: (y, z) from (main, along)
  {
    for (const double sign : {-1., 1.})
    {
      add([sign](const double along) { return std::pair(sign, along); });
      add([sign](const double along) { return std::pair(along, sign); });
    }
  };

  if (nose > 0.)
    for (const double end : is_sphere ? std::vector<double>{1., -1.} : std::vector<double>{1.})
    {
      const auto place = [&](const Vector3 &unit)
      {
        Vector3 x = nose_point(unit);
        x.x()     = shoulder + end * (x.x() - shoulder);
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
  if (shank > 0.)
  {
    // As long as the cells of the square are wide, on an average.
    const int layers =
        std::max(1, static_cast<int>(std::lround(shank * n / (2. * radius * 0.75)) ));
    const auto place = [&](const int i, const Vector3 &unit)
    {
      return Vector3(body.base_position() + shank * i / layers, radius * unit.y(),
                     radius * unit.z());
    };
    builder.block({layers, n, n},
                  [&](const int i, const int j, const int k)
                  { return place(i, in_box({0., coordinate(j), coordinate(k)})); });
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
      x[d] = std::abs(x[d]) < 1e-7 * shape.diameter ? 0. : widen * x[d];
  return solid;
}
} // namespace ricochet
