// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/rigid_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
namespace
{
Eigen::Quaterniond rotation(const Vector3 &vector) // axis times angle [rad]
{
  const double angle = vector.norm();
  if (angle == 0.)
    return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}
} // namespace

RigidBody::RigidBody(const BodyOfRevolution &body, const double mass, const Motion &start,
                     const bool planar) :
  body_(body),
  mass_(mass), planar_(planar), motion_(start)
{
  const auto gyration   = body.gyration_squared();
  const Vector3 inertia = mass * Vector3(gyration[0], gyration[1], gyration[1]);
  const Vector3 in_body = start.orientation.conjugate() * start.spin;
  angular_momentum_     = start.orientation * inertia.cwiseProduct(in_body);
}

Vector3 RigidBody::spin_from_momentum(const Eigen::Quaterniond &orientation) const
{
  const auto gyration   = body_.gyration_squared();
  const Vector3 inertia = mass_ * Vector3(gyration[0], gyration[1], gyration[1]);
  return orientation * (orientation.conjugate() * angular_momentum_).cwiseQuotient(inertia);
}

void RigidBody::advance(const Vector3 &force, const Vector3 &moment, const double kick,
                        const double drift)
{
  motion_.velocity += kick / mass_ * force;
  angular_momentum_ += kick * moment;
  if (planar_)
  {
    motion_.velocity.y()  = 0.;
    angular_momentum_.x() = angular_momentum_.z() = 0.;
  }
  const Eigen::Quaterniond half =
      rotation(drift / 2. * spin_from_momentum(motion_.orientation)) * motion_.orientation;
  motion_.spin = spin_from_momentum(half);
  motion_.position += drift * motion_.velocity;
  motion_.orientation = (rotation(drift * motion_.spin) * motion_.orientation).normalized();
}

double RigidBody::pitch() const
{
  return std::asin(std::clamp(axis().z(), -1., 1.));
}

BodyOfRevolution::Hit RigidBody::hit(const Vector3 &point) const
{
  auto hit   = body_.hit(motion_.orientation.conjugate() * (point - motion_.position));
  hit.normal = motion_.orientation * hit.normal;
  return hit;
}

std::pair<Vector3, Vector3> RigidBody::bounding_box() const
{
  // A circle of radius r about the axis a reaches r sqrt(1 - a_i^2) along the coordinate i.
  const Vector3 a = axis();
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const auto &[x, r] : body_.profile(200))
    for (int i = 0; i < 3; ++i)
    {
      const double across = r * std::sqrt(std::max(0., 1. - a[i] * a[i]));
      low[i]              = std::min(low[i], a[i] * x - across);
      high[i]             = std::max(high[i], a[i] * x + across);
    }
  return {motion_.position + low, motion_.position + high};
}
} // namespace ricochet
