// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/rigid_contact.h"

#include "field_values.h"

#include <Eigen/Eigenvalues>

#include <array>

namespace ricochet
{
namespace
{
/// Velocity of the touched place across the normal, by that of the body.
Eigen::Matrix<double, 3, 6> sliding_by_motion(const Vector3 &arm, const Vector3 &normal)
{
  Eigen::Matrix3d spin; // spin x arm = spin_matrix * spin
  spin << 0., arm.z(), -arm.y(), -arm.z(), 0., arm.x(), arm.y(), -arm.x(), 0.;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  Eigen::Matrix<double, 3, 6> J;
  J << across, across * spin;
  return J;
}

/// A bound of J M^-1 J^T [1/kg].
double compliance_of(const RigidBody &body, const Matrix6 &sliding)
{
  const Matrix6 root = body.root_of_mobility();
  return Eigen::SelfAdjointEigenSolver<Matrix6>(root.transpose() * sliding * root,
                                                Eigen::EigenvaluesOnly)
      .eigenvalues()[5];
}

Vector3 vector_from(const double *const values)
{
  return Eigen::Map<const Vector3>(values);
}
} // namespace

RigidContact::Press &RigidContact::Press::operator+=(const Press &other)
{
  force += other.force;
  moment += other.moment;
  sliding += other.sliding;
  return *this;
}

RigidContact::RigidContact(const MPI_Comm communicator, const FrictionLaw &law,
                           const Parameters &parameters, const bool mirrored, const int n_planes) :
  communicator_(communicator),
  law_(law), pair_law_(parameters), multiplicity_(mirrored ? 2. : 1.), normal_sums_(n_planes),
  friction_sums_(n_planes), work_(n_planes)
{
}

RigidContact::Press RigidContact::add_normal_forces(const RigidBody &projectile,
                                                    PeridynamicBody &plate)
{
  const Lattice &lattice       = plate.lattice();
  const double *const *const x = plate.state().arrays.position;
  const double radius          = lattice.box().spacing / 2.;
  const auto [low, high]       = projectile.bounding_box();
  const Vector3 first = low - Vector3::Constant(radius), last = high + Vector3::Constant(radius);
  normal_sums_.clear();
  touching_.clear();
  std::array<double, 2> largest{}; // depth; 1 if a point follows elements
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (is_outside(x, p, first, last))
          return;
        const auto hit     = projectile.hit(at(x, p));
        const double depth = radius - hit.distance;
        if (depth <= 0.)
          return;
        touch(p, hit, depth, projectile, plate);
        largest[0] = std::max(largest[0], depth);
        if (!lattice.free(p))
          largest[1] = 1.;
      });

  const auto sum = normal_sums_.total(communicator_);
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);
  Press press{vector_from(&sum[0]), vector_from(&sum[3]), Matrix6::Zero()};
  for (int i = 0, entry = 8; i < 6; ++i)
    for (int j = i; j < 6; ++j, ++entry)
      press.sliding(i, j) = press.sliding(j, i) = sum[entry];
  if (multiplicity_ == 2.)
    add_mirrored_half(press);
  record_                     = {};
  record_.normal              = press.force;
  record_.moment              = press.moment;
  record_.energy              = multiplicity_ * sum[6];
  record_.n_touching          = multiplicity_ * sum[7];
  record_.deepest             = largest[0];
  record_.deepest_in_spacings = largest[0] / lattice.box().spacing;
  record_.on_elements         = largest[1] > 0.;
  return press;
}

/// A point's normal force.
void RigidContact::touch(const std::ptrdiff_t point, const BodyOfRevolution::Hit &hit,
                         const double depth, const RigidBody &projectile, PeridynamicBody &plate)
{
  auto &a           = plate.state().arrays;
  const Vector3 arm = at(a.position, point) - projectile.motion().position;
  touching_.push_back(
      {point, arm, hit.normal, hit.surface == BodyOfRevolution::Surface::shank, depth});
  const Vector3 force  = pair_law_.normal_force(depth) * hit.normal;
  const Vector3 moment = -arm.cross(force);
  auto &sum            = normal_sums_[plate.lattice().plane_of(point)];
  for (int d = 0; d < 3; ++d)
  {
    a.force[d][point] += force[d];
    sum[d] -= force[d];
    sum[3 + d] += moment[d];
  }
  sum[6] += pair_law_.energy(depth);
  sum[7] += 1.;
  const auto J            = sliding_by_motion(arm, hit.normal);
  const Matrix6 of_motion = J.transpose() * J;
  for (int i = 0, entry = 8; i < 6; ++i)
    for (int j = i; j < 6; ++j, ++entry)
      sum[entry] += of_motion(i, j);
}

ContactRecord RigidContact::add_friction(const RigidBody &projectile, const Press &press,
                                         PeridynamicBody &plate, const double dt)
{
  friction_sums_.clear();
  work_.clear();
  const auto present      = projectile.present_motion(press.force, press.moment, dt);
  const double compliance = 1. / plate.point_mass() + compliance_of(projectile, press.sliding);
  for (const auto &touching : touching_)
    rub(touching, present, compliance, plate, dt);

  const auto sum = friction_sums_.total(communicator_);
  ContactRecord friction;
  friction.friction        = vector_from(&sum[0]);
  friction.shank           = vector_from(&sum[3]);
  friction.friction_moment = friction.moment = vector_from(&sum[6]);
  if (multiplicity_ == 2.)
    add_mirrored_half(friction);
  record_ += friction;
  return record_;
}

/// A point's friction.
void RigidContact::rub(const Touching &touching, const RigidBody::Motion &present,
                       const double compliance, PeridynamicBody &plate, const double dt)
{
  const auto &[point, arm, n, on_shank, depth] = touching;
  auto &a                                      = plate.state().arrays;
  // What follows elements gets more than its own forces: its velocity is taken as it is.
  const double half_kick = plate.lattice().free(point) ? dt / (2. * plate.point_mass()) : 0.;
  const Vector3 velocity = at(a.velocity, point) + half_kick * at(a.force, point);
  const Vector3 sliding =
      sliding_velocity(Vector3(velocity - present.velocity - present.spin.cross(arm)), n);
  const double speed      = sliding.norm();
  const double mu         = law_.coefficient(speed);
  const double normal     = pair_law_.normal_force(depth);
  const double shank_push = on_shank ? pair_law_.shank_push(normal) : 0.;
  const double push       = normal + shank_push;
  const Vector3 force     = -pair_law_.resistance(speed, mu * push, compliance, dt) * sliding;
  const Vector3 shank = shank_push / push * force, friction = normal / push * force,
                moment = -arm.cross(force);
  auto &sum            = friction_sums_[plate.lattice().plane_of(point)];
  for (int d = 0; d < 3; ++d)
  {
    a.force[d][point] += force[d];
    sum[d] -= friction[d];
    sum[3 + d] -= shank[d];
    sum[6 + d] += moment[d];
  }
  work_.add(plate, point, force);
}

ContactRecord RigidContact::add_forces(const RigidBody &projectile, PeridynamicBody &plate,
                                       const double dt)
{
  const Press press = add_normal_forces(projectile, plate);
  return add_friction(projectile, press, plate, dt);
}

void RigidContact::add_mirrored_half(Press &press) const
{
  press.force  = Vector3(2. * press.force.x(), 0., 2. * press.force.z());
  press.moment = Vector3(0., 2. * press.moment.y(), 0.);
  press.sliding *= 2.; // what the plane forbids is not in the body's mobility
}

void RigidContact::add_mirrored_half(ContactRecord &record) const
{
  for (Vector3 *force : {&record.friction, &record.shank})
    *force = Vector3(2. * force->x(), 0., 2. * force->z());
  for (Vector3 *moment : {&record.moment, &record.friction_moment})
    *moment = Vector3(0., 2. * moment->y(), 0.);
}
} // namespace ricochet
