// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface_tangents.h"

#include <Eigen/Dense>

#include <cmath>

namespace ricochet
{
SurfaceTangents::SurfaceTangents(const FacetedSurface &surface, const FacetedSurface::Hit &hit)
{
  const Vector3 &n     = hit.normal;
  const auto &quad     = surface.faces()[hit.face];
  const Vector3 along  = surface.node(quad[2]) - surface.node(quad[0]);
  const Vector3 across = surface.node(quad[3]) - surface.node(quad[1]);
  // At an edge n may point along one of the diagonals, but not along both.
  const Vector3 &longer =
      std::abs(n.dot(along)) * across.norm() < std::abs(n.dot(across)) * along.norm() ? along
                                                                                      : across;
  direction[0] = (longer - n.dot(longer) * n).normalized();
  direction[1] = n.cross(direction[0]);

  // With in-plane places (s, t) about the mean and g = alpha s + beta t, the couple g_a n of the
  // unit force along the tangent i needs sum g s = -phi for i = 0, sum g t = -phi for i = 1.
  Vector3 mean = Vector3::Zero();
  for (const int node : quad)
    mean += 0.25 * surface.node(node);
  Eigen::Vector2d place[4];
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int a = 0; a < 4; ++a)
  {
    const Vector3 arm = surface.node(quad[a]) - mean;
    place[a]          = {arm.dot(direction[0]), arm.dot(direction[1])};
    second += place[a] * place[a].transpose();
  }
  const Eigen::Matrix2d slopes = -hit.distance * second.inverse();
  for (int i = 0; i < 2; ++i)
    for (int a = 0; a < 4; ++a)
      on_node[i][a] = hit.weights[a] * direction[i] + slopes.col(i).dot(place[a]) * n;
}

double SurfaceTangents::reach(const int node) const
{
  // The larger singular value of the two rows.
  const Vector3 &s = on_node[0][node], &t = on_node[1][node];
  const double mean = 0.5 * (s.squaredNorm() + t.squaredNorm()),
               half = 0.5 * (s.squaredNorm() - t.squaredNorm());
  return std::sqrt(mean + std::hypot(half, s.dot(t)));
}
} // namespace ricochet
