// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/rigid_contact.h"

#include "field_values.h"

#include <array>

namespace ricochet
{
RigidContact::RigidContact(const MPI_Comm communicator, const FrictionLaw &law,
                           const Parameters &parameters, const bool mirrored, const int n_planes) :
  communicator_(communicator),
  law_(law), pair_law_(parameters), multiplicity_(mirrored ? 2. : 1.), sums_(n_planes),
  work_(n_planes)
{
}

ContactRecord RigidContact::add_forces(const RigidBody &projectile, PeridynamicBody &plate)
{
  const Lattice &lattice       = plate.lattice();
  const double *const *const x = plate.state().arrays.position;
  const double radius          = lattice.box().spacing / 2.;
  const auto [low, high]       = projectile.bounding_box();
  const Vector3 first = low - Vector3::Constant(radius), last = high + Vector3::Constant(radius);
  sums_.clear();
  work_.clear();
  deepest_ = on_elements_ = 0.;
  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (is_outside(x, p, first, last))
          return;
        const Vector3 position = at(x, p);
        const auto hit         = projectile.hit(position);
        const double depth     = radius - hit.distance;
        if (depth > 0.)
          add_point_forces(p, position, hit, depth, projectile, plate);
      });
  return record(lattice.box().spacing);
}

void RigidContact::add_point_forces(const std::ptrdiff_t point, const Vector3 &position,
                                    const BodyOfRevolution::Hit &hit, const double depth,
                                    const RigidBody &projectile, PeridynamicBody &plate)
{
  auto &a                 = plate.state().arrays;
  const Vector3 relative  = at(a.velocity, point) - projectile.velocity_at(position);
  const Vector3 sliding   = sliding_velocity(relative, hit.normal);
  const double speed      = sliding.norm();
  const double mu         = law_.coefficient(speed);
  const double normal     = pair_law_.normal_force(depth);
  const Vector3 direction = pair_law_.direction(sliding, speed);

  const Vector3 normal_force = normal * hit.normal;
  const Vector3 friction     = pair_law_.friction_limit(mu, normal) * direction;
  const Vector3 shank        = hit.surface == BodyOfRevolution::Surface::shank
                                   ? Vector3(pair_law_.shank_limit(mu) * direction)
                                   : Vector3(Vector3::Zero());
  const Vector3 total        = normal_force + friction + shank;
  for (int d = 0; d < 3; ++d)
    a.force[d][point] += total[d];
  work_.add(plate, point, friction + shank);

  const Vector3 arm             = position - projectile.motion().position;
  const Vector3 moment          = -arm.cross(total);
  const Vector3 friction_moment = -arm.cross(friction + shank);
  auto &sum                     = sums_[plate.lattice().plane_of(point)];
  for (int d = 0; d < 3; ++d)
  {
    sum[d] -= normal_force[d];
    sum[3 + d] -= friction[d];
    sum[6 + d] -= shank[d];
    sum[9 + d] += moment[d];
    sum[12 + d] += friction_moment[d];
  }
  sum[15] += pair_law_.energy(depth);
  sum[16] += 1.;
  deepest_ = std::max(deepest_, depth);
  if (!plate.lattice().free(point))
    on_elements_ = 1.;
}

ContactRecord RigidContact::record(const double spacing) const
{
  const auto sum = sums_.total(communicator_);
  std::array<double, 2> largest{deepest_, on_elements_};
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);
  const auto vector_from = [&](const int i)
  { return Vector3(multiplicity_ * Vector3(sum[i], sum[i + 1], sum[i + 2])); };
  ContactRecord record;
  record.normal              = vector_from(0);
  record.friction            = vector_from(3);
  record.shank               = vector_from(6);
  record.moment              = vector_from(9);
  record.friction_moment     = vector_from(12);
  record.energy              = multiplicity_ * sum[15];
  record.deepest             = largest[0];
  record.deepest_in_spacings = largest[0] / spacing;
  record.n_touching          = multiplicity_ * sum[16];
  record.on_elements         = largest[1] > 0.;
  if (multiplicity_ == 2.)
  {
    for (Vector3 *force : {&record.normal, &record.friction, &record.shank})
      force->y() = 0.;
    for (Vector3 *moment : {&record.moment, &record.friction_moment})
      moment->x() = moment->z() = 0.;
  }
  return record;
}
} // namespace ricochet
