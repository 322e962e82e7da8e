// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unit_ball.h"

#include <cmath>

namespace ricochet
{
namespace
{
// By how much the sides bulge outwards: with this and the half width the smallest edge, which
// decides the time step, is as large as it can be.
constexpr double bulge = 0.1;

/// Rays through faces of the cube at equal angles.
Vector3 on_sphere(const Vector3 &u)
{
  return Vector3(std::tan(M_PI / 4. * u[0]), std::tan(M_PI / 4. * u[1]), std::tan(M_PI / 4. * u[2]))
      .normalized();
}
} // namespace

Vector3 in_box(const Vector3 &u)
{
  const double furthest = u.cwiseAbs().maxCoeff();
  if (furthest == 0.)
    return Vector3::Zero();
  const Vector3 round = on_sphere(u) * (inner_half_width * furthest);
  return (1. - bulge) * inner_half_width * u + bulge * std::sqrt(2.) * round;
}

Vector3 around_box(const Vector3 &u, const double s)
{
  return (1. - s) * in_box(u) + s * on_sphere(u);
}
} // namespace ricochet
