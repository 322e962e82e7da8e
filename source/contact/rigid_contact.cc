// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/rigid_contact.h"

#include <array>
#include <cmath>

namespace ricochet
{
RigidContact::Reaction &RigidContact::Reaction::operator+=(const Reaction &other)
{
  normal += other.normal;
  friction += other.friction;
  shank += other.shank;
  moment += other.moment;
  friction_moment += other.friction_moment;
  energy += other.energy;
  n_touching += other.n_touching;
  on_elements = on_elements || other.on_elements;
  deepest     = std::max(deepest, other.deepest);
  return *this;
}

RigidContact::RigidContact(const MPI_Comm communicator, const FrictionLaw &law,
                           const Parameters &parameters, const bool mirrored, const int n_planes) :
  communicator_(communicator),
  law_(law), parameters_(parameters), multiplicity_(mirrored ? 2. : 1.), sums_(n_planes),
  work_(n_planes)
{
}

RigidContact::Reaction RigidContact::evaluate(const RigidBody &projectile, PeridynamicBody &plate)
{
  const Lattice &lattice = plate.lattice();
  auto &a                = plate.state().arrays;
  const double radius    = lattice.box().spacing / 2.;
  const auto [low, high] = projectile.bounding_box();
  const Vector3 first = low - Vector3::Constant(radius), last = high + Vector3::Constant(radius);
  double deepest = 0., on_elements = 0.;
  sums_.clear();
  active_.clear();

  lattice.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        // The first three comparisons dismiss nearly all points.
        if (a.position[0][p] < first.x() || a.position[0][p] > last.x() ||
            a.position[2][p] < first.z() || a.position[2][p] > last.z() ||
            a.position[1][p] < first.y() || a.position[1][p] > last.y())
          return;
        const Vector3 x(a.position[0][p], a.position[1][p], a.position[2][p]);
        const auto hit     = projectile.hit(x);
        const double depth = radius - hit.distance;
        if (depth <= 0.)
          return;

        const Vector3 velocity(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
        const Vector3 relative = velocity - projectile.velocity_at(x);
        const Vector3 sliding  = relative - relative.dot(hit.normal) * hit.normal;
        const double speed     = sliding.norm();
        // Below the regularisation speed v_t/|v_t| is replaced by v_t/v_reg: a force that does not
        // jump with its sign.
        const Vector3 against  = -sliding / std::max(speed, parameters_.regularisation_speed);
        const double mu        = law_.coefficient(speed);
        const double pressure  = parameters_.stiffness * depth;
        const Vector3 normal   = pressure * hit.normal;
        const Vector3 friction = mu * pressure * against;
        const Vector3 shank    = hit.surface == BodyOfRevolution::Surface::shank
                                     ? Vector3(mu * parameters_.shank_force * against)
                                     : Vector3(Vector3::Zero());
        const Vector3 total    = normal + friction + shank;
        for (int d = 0; d < 3; ++d)
          a.force[d][p] += total[d];
        active_.push_back({p, friction + shank, velocity});

        const Vector3 arm             = x - projectile.motion().position;
        const Vector3 moment          = -arm.cross(total);
        const Vector3 friction_moment = -arm.cross(friction + shank);
        auto &sum                     = sums_[lattice.plane_of(p)];
        for (int d = 0; d < 3; ++d)
        {
          sum[d] -= normal[d];
          sum[3 + d] -= friction[d];
          sum[6 + d] -= shank[d];
          sum[9 + d] += moment[d];
          sum[12 + d] += friction_moment[d];
        }
        sum[15] += 0.5 * pressure * depth;
        sum[16] += 1.;
        deepest = std::max(deepest, depth);
        if (!lattice.free(p))
          on_elements = 1.;
      });

  const auto sum = sums_.total(communicator_);
  std::array<double, 2> largest{deepest, on_elements};
  MPI_Allreduce(MPI_IN_PLACE, largest.data(), 2, MPI_DOUBLE, MPI_MAX, communicator_);
  const auto vector = [&](const int i)
  { return Vector3(multiplicity_ * Vector3(sum[i], sum[i + 1], sum[i + 2])); };
  Reaction reaction{vector(0),      vector(3),
                    vector(6),      vector(9),
                    vector(12),     multiplicity_ * sum[15],
                    largest[0],     multiplicity_ * sum[16],
                    largest[1] > 0.};
  if (multiplicity_ == 2.)
  {
    for (Vector3 *force : {&reaction.normal, &reaction.friction, &reaction.shank})
      force->y() = 0.;
    for (Vector3 *moment : {&reaction.moment, &reaction.friction_moment})
      moment->x() = moment->z() = 0.;
  }
  return reaction;
}

void RigidContact::record_work(const PeridynamicBody &plate, const double dt)
{
  const auto &a = plate.state().arrays;
  for (const auto &touch : active_)
  {
    const Vector3 after(a.velocity[0][touch.point], a.velocity[1][touch.point],
                        a.velocity[2][touch.point]);
    work_[plate.lattice().plane_of(touch.point)][0] +=
        0.5 * dt * touch.friction.dot(touch.velocity + after);
  }
}

double RigidContact::work_on_points() const
{
  return multiplicity_ * work_.total(communicator_)[0];
}
} // namespace ricochet
