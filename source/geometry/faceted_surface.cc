// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/geometry/faceted_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
/// Barycentric coordinates of the point of the triangle a, b, c that is nearest to p (Ericson 2005,
/// Real-time collision detection, 5.1.5).
Vector3 nearest_on_triangle(const Vector3 &p, const Vector3 &a, const Vector3 &b, const Vector3 &c)
{
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0. && d2 <= 0.)
    return {1., 0., 0.};
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0. && d4 <= d3)
    return {0., 1., 0.};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0. && d1 >= 0. && d3 <= 0.)
  {
    const double v = d1 / (d1 - d3);
    return {1. - v, v, 0.};
  }
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0. && d5 <= d6)
    return {0., 0., 1.};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0. && d2 >= 0. && d6 <= 0.)
  {
    const double w = d2 / (d2 - d6);
    return {1. - w, 0., w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0. && d4 - d3 >= 0. && d5 - d6 >= 0.)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0., 1. - w, w};
  }
  const double v = vb / (va + vb + vc), w = vc / (va + vb + vc);
  return {1. - v - w, v, w};
}
} // namespace

void FacetedSurface::update(const std::vector<double> &position, const double reach)
{
  position_ = position;
  reach_    = reach;
  low_      = Vector3::Constant(std::numeric_limits<double>::max());
  high_     = -low_;
  spheres_.resize(faces_.size());
  std::vector<std::pair<Vector3, Vector3>> boxes(faces_.size());
  double size = 0.;
  for (std::size_t face = 0; face < faces_.size(); ++face)
  {
    Vector3 low = node(faces_[face][0]), high = low, centre = Vector3::Zero();
    for (const int number : faces_[face])
    {
      low  = low.cwiseMin(node(number));
      high = high.cwiseMax(node(number));
      centre += 0.25 * node(number);
    }
    double radius = 0.;
    for (const int number : faces_[face])
      radius = std::max(radius, (node(number) - centre).norm());
    spheres_[face] = {centre, radius};
    boxes[face]    = {low - Vector3::Constant(reach), high + Vector3::Constant(reach)};
    low_           = low_.cwiseMin(low);
    high_          = high_.cwiseMax(high);
    size += radius;
  }

  // Cells about as large as a face with its reach: a face is listed in about eight of them.
  const Vector3 corner = low_ - Vector3::Constant(reach),
                extent = high_ - low_ + Vector3::Constant(2. * reach);
  cell_                = std::max(
                     {size / static_cast<double>(faces_.size()) + reach, std::cbrt(extent.prod() / 1e6), 1e-300});
  for (int d = 0; d < 3; ++d)
    n_[d] = static_cast<int>(extent[d] / cell_) + 1;
  starts_.assign(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2] + 1, 0);
  const auto for_each_cell = [&](const std::size_t face, auto &&visit)
  {
    int first[3], last[3];
    for (int d = 0; d < 3; ++d)
    {
      first[d] = std::clamp(int((boxes[face].first[d] - corner[d]) / cell_), 0, n_[d] - 1);
      last[d]  = std::clamp(int((boxes[face].second[d] - corner[d]) / cell_), 0, n_[d] - 1);
    }
    for (int i = first[0]; i <= last[0]; ++i)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int k = first[2]; k <= last[2]; ++k)
          visit((i * n_[1] + j) * n_[2] + k);
  };
  for (std::size_t face = 0; face < faces_.size(); ++face)
    for_each_cell(face, [&](const int cell) { ++starts_[cell + 1]; });
  for (std::size_t cell = 1; cell < starts_.size(); ++cell)
    starts_[cell] += starts_[cell - 1];
  entries_.resize(starts_.back());
  std::vector<int> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t face = 0; face < faces_.size(); ++face)
    for_each_cell(face, [&](const int cell) { entries_[next[cell]++] = static_cast<int>(face); });
}

bool FacetedSurface::improve(const int face, const Vector3 &point, double &squared, double &cosine,
                             Hit &hit) const
{
  // At an edge or a corner several triangles are equally near; the sign of the distance is that of
  // the one which looks at the point most squarely.
  constexpr double tie = 1e-9;
  const auto &quad     = faces_[face];
  const Vector3 centre = spheres_[face].centre;
  bool improved        = false;
  for (int side = 0; side < 4; ++side)
  {
    const int next  = (side + 1) % 4;
    const Vector3 a = node(quad[side]), b = node(quad[next]);
    const Vector3 share   = nearest_on_triangle(point, a, b, centre);
    const Vector3 nearest = share[0] * a + share[1] * b + share[2] * centre;
    const Vector3 away    = point - nearest;
    const double d2       = away.squaredNorm();
    if (d2 > squared * (1. + tie))
      continue;
    const Vector3 normal  = (b - a).cross(centre - a).normalized();
    const double length   = std::sqrt(d2);
    const double along    = normal.dot(away);
    const bool on_it      = length <= 1e-9 * spheres_[face].radius;
    const double squarely = on_it ? 1. : std::abs(along) / length;
    if (d2 > squared * (1. - tie) && squarely <= cosine)
      continue;
    squared      = std::min(squared, d2);
    cosine       = squarely;
    improved     = true;
    hit.face     = face;
    hit.distance = along < 0. ? -length : length;
    hit.normal   = on_it ? normal : Vector3(away / hit.distance);
    for (double &weight : hit.weights)
      weight = 0.25 * share[2];
    hit.weights[side] += share[0];
    hit.weights[next] += share[1];
  }
  return improved;
}

bool FacetedSurface::hit(const Vector3 &point, Hit &hit) const
{
  std::size_t cell = 0;
  for (int d = 0; d < 3; ++d)
  {
    const double place = (point[d] - low_[d] + reach_) / cell_;
    if (!(place >= 0.) || place >= n_[d])
      return false;
    cell = cell * n_[d] + static_cast<std::size_t>(place);
  }
  double squared = reach_ * reach_, cosine = -1.;
  bool found = false;
  for (int i = starts_[cell]; i < starts_[cell + 1]; ++i)
  {
    const int face     = entries_[i];
    const double limit = std::sqrt(squared) * (1. + 1e-9) + spheres_[face].radius;
    if ((point - spheres_[face].centre).squaredNorm() > limit * limit)
      continue;
    found = improve(face, point, squared, cosine, hit) || found;
  }
  return found;
}

FacetedSurface::Hit FacetedSurface::nearest(const Vector3 &point) const
{
  double squared = std::numeric_limits<double>::max(), cosine = -1.;
  Hit hit{};
  for (int face = 0; face < static_cast<int>(faces_.size()); ++face)
    improve(face, point, squared, cosine, hit);
  return hit;
}
} // namespace ricochet
