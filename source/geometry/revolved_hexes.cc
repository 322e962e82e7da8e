// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/revolved_hexes.h"

#include "revolved_nose.h"
#include "ricochet/base/exceptions.h"
#include "unit_ball.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ricochet
{
namespace
{
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

/// The numbers of one mesh.
struct Division
{
  Division(const BodyOfRevolution &body, const int refinement) :
    is_sphere(body.shape().nose == NoseShape::sphere), n(1 << refinement), m(n / 2),
    radius(body.shape().diameter / 2.), nose(is_sphere ? radius : body.shape().nose_length),
    shank(body.shape().length - (is_sphere ? 2. : 1.) * nose),
    widen(std::sqrt(2. * M_PI / (4. * n) / std::sin(2. * M_PI / (4. * n))))
  {
  }
  double coordinate(const int i) const { return 2. * i / n - 1.; }

  bool is_sphere;
  int n;                      // cells across the inner square
  int m;                      // from the square to the circumference
  double radius, nose, shank; // lengths [m]
  double widen;               // the polygon of 4 n edges gets the area of its circle
};

/// Calls add(side) for the four sides of the square, with side(t) = (y, z) along each.
template <class Add>
void all_around(Add &&add)
{
  for (const double sign : {-1., 1.})
  {
    add([sign](const double along) { return std::pair(sign, along); });
    add([sign](const double along) { return std::pair(along, sign); });
  }
}

/// Half a ball: the box, the block in front of it and those around it. `place` of its points.
template <class Place>
void add_half_ball(Builder &builder, const Division &cut, Place &&place)
{
  const int n = cut.n, m = cut.m;
  builder.block({n, n, n},
                [&](const int i, const int j, const int k) {
                  return place(in_box({double(i) / n, cut.coordinate(j), cut.coordinate(k)}));
                });
  builder.block(
      {m, n, n},
      [&](const int i, const int j, const int k) {
        return place(around_box({1., cut.coordinate(j), cut.coordinate(k)}, double(i) / m));
      });
  all_around(
      [&](auto &&side)
      {
        builder.block({n, n, m},
                      [&](const int i, const int j, const int k)
                      {
                        const auto [y, z] = side(cut.coordinate(j));
                        return place(around_box({double(i) / n, y, z}, double(k) / m));
                      });
      });
}

/// The other end of a sphere is the nose in the mirror.
void add_nose(Builder &builder, const Division &cut, const BodyOfRevolution &body)
{
  const RevolvedNose nose(body, cut.nose, cut.n, cut.widen);
  for (const double end : cut.is_sphere ? std::vector<double>{1., -1.} : std::vector<double>{1.})
    add_half_ball(builder, cut,
                  [&](const Vector3 &unit)
                  {
                    Vector3 x = nose.place(unit);
                    x.x()     = nose.shoulder() + end * (x.x() - nose.shoulder());
                    return x;
                  });
}

/// The disc, extruded.
void add_shank(Builder &builder, const Division &cut, const BodyOfRevolution &body)
{
  // A third longer than the cells of the square are wide.
  const int layers =
      std::max(1, static_cast<int>(std::lround(0.75 * cut.shank * cut.n /
                                               (2. * inner_half_width * cut.radius))));
  const auto place = [&](const int i, const Vector3 &unit)
  {
    return Vector3(body.base_position() + cut.shank * i / layers, cut.widen * cut.radius * unit.y(),
                   cut.widen * cut.radius * unit.z());
  };
  builder.block({layers, cut.n, cut.n},
                [&](const int i, const int j, const int k) {
                  return place(i, in_box({0., cut.coordinate(j), cut.coordinate(k)}));
                });
  all_around(
      [&](auto &&side)
      {
        builder.block({layers, cut.n, cut.m},
                      [&](const int i, const int j, const int k)
                      {
                        const auto [y, z] = side(cut.coordinate(j));
                        return place(i, around_box({0., y, z}, double(k) / cut.m));
                      });
      });
}
} // namespace

HexSolid revolved_hexes(const BodyOfRevolution &body, const int refinement)
{
  if (refinement < 1 || refinement > 4)
    throw InputError("The refinement of the projectile's mesh is " + std::to_string(refinement) +
                     "; it must lie between 1 and 4.");
  const Division cut(body, refinement);
  const double tolerance = 1e-7 * body.shape().diameter; // [m]
  Builder builder(tolerance);
  if (cut.nose > 0.)
    add_nose(builder, cut, body);
  if (cut.shank > 0.)
    add_shank(builder, cut, body);
  HexSolid solid = builder.take();
  for (auto &x : solid.nodes)
    for (int d = 1; d < 3; ++d)
      if (std::abs(x[d]) < tolerance)
        x[d] = 0.;
  return solid;
}
} // namespace ricochet
