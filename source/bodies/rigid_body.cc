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
  RigidBody(body, mass,
            mass * Vector3(body.gyration_squared()[0], body.gyration_squared()[1],
                           body.gyration_squared()[1]),
            start, planar)
{
}

RigidBody::RigidBody(const BodyOfRevolution &body, const double mass, const Vector3 &inertia,
                     const Motion &start, const bool planar) :
  body_(body),
  mass_(mass), inertia_(inertia), planar_(planar), motion_(start)
{
  const Vector3 in_body = start.orientation.conjugate() * start.spin;
  angular_momentum_     = start.orientation * inertia_.cwiseProduct(in_body);
}

Vector3 RigidBody::spin_from_momentum(const Eigen::Quaterniond &orientation,
                                      const Vector3 &angular_momentum) const
{
  return orientation * (orientation.conjugate() * angular_momentum).cwiseQuotient(inertia_);
}

void RigidBody::restrict(Vector3 &linear, Vector3 &angular) const
{
  if (planar_)
    linear.y() = angular.x() = angular.z() = 0.;
}

void RigidBody::advance(const Vector3 &force, const Vector3 &moment, const double kick,
                        const double drift)
{
  if (!driven_)
  {
    motion_.velocity += kick / mass_ * force;
    angular_momentum_ += kick * moment;
  }
  restrict(motion_.velocity, angular_momentum_);
  // The half step's orientation depends on its spin and the other way round. Each turn of the loop
  // gains a factor of half the angle of a step, a hundredth at most: six are rounding. About one
  // axis the first is exact.
  motion_.spin    = spin_from_momentum(motion_.orientation, angular_momentum_);
  const int turns = planar_ ? 1 : 6;
  for (int turn = 0; turn < turns; ++turn)
    motion_.spin = spin_from_momentum(rotation(drift / 2. * motion_.spin) * motion_.orientation,
                                      angular_momentum_);
  motion_.position += drift * motion_.velocity;
  motion_.orientation = (rotation(drift * motion_.spin) * motion_.orientation).normalized();
}

RigidBody::Motion RigidBody::present_motion(const Vector3 &force, const Vector3 &moment,
                                            const double kick) const
{
  if (driven_)
    return motion_;
  Motion present           = motion_;
  Vector3 angular_momentum = angular_momentum_ + kick / 2. * moment;
  present.velocity += kick / 2. / mass_ * force;
  restrict(present.velocity, angular_momentum);
  present.spin = spin_from_momentum(motion_.orientation, angular_momentum);
  return present;
}

Matrix6 RigidBody::root_of_mobility() const
{
  Matrix6 root = Matrix6::Zero();
  if (driven_)
    return root;
  root.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() / std::sqrt(mass_);
  root.bottomRightCorner<3, 3>() =
      motion_.orientation.toRotationMatrix() * inertia_.cwiseSqrt().cwiseInverse().asDiagonal();
  if (planar_)
    for (const int held : {1, 3, 5})
      root.row(held).setZero();
  return root;
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

void RigidBody::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "rigid body");
  archive.common("position", motion_.position);
  archive.common("velocity", motion_.velocity);
  archive.common("orientation", motion_.orientation.coeffs().data(), 4);
  archive.common("spin", motion_.spin);
  archive.common("angular momentum", angular_momentum_);
}
} // namespace ricochet
