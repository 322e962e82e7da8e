// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/short_range_contact.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ricochet
{
namespace
{
// In compact debris about so many neighbours push or rub at once.
constexpr double crowd = 6.;

/// k = factor 18 K V^2 / (pi delta^5) [N/m]
double pair_stiffness(const PeridynamicBody &body, const double factor)
{
  const auto &stencil = body.lattice().stencil();
  const double volume = std::pow(stencil.spacing, 3);
  return factor * 18. * body.material().bulk_modulus / (M_PI * std::pow(stencil.horizon, 5)) *
         volume * volume;
}

int most_planes(const Bodies &bodies)
{
  int n = 0;
  for (const auto &body : bodies)
    n = std::max(n, body->lattice().box().n[0]);
  return n;
}

Vector3 at(const double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

Vector3 vector(const double (&x)[3])
{
  return {x[0], x[1], x[2]};
}

/// Points at the same place do not touch: there is no direction to push them apart.
bool is_touch(const double squared, const double distance)
{
  return (squared < distance * distance) & (squared != 0.);
}
} // namespace

ShortRangeContact::ShortRangeContact(const MPI_Comm communicator, const Bodies &bodies,
                                     const double factor, const bool mirrored,
                                     const std::string &search) :
  ShortRangeContact(communicator, bodies, factor, mirrored, search, Friction{})
{
}

ShortRangeContact::ShortRangeContact(const MPI_Comm communicator, const Bodies &bodies,
                                     const double factor, const bool mirrored,
                                     const std::string &search, const Friction &friction) :
  communicator_(communicator),
  bodies_(bodies), factor_(factor), mirrored_(mirrored), friction_(friction),
  pairs_(communicator, bodies_, mirrored, search), work_(most_planes(bodies))
{
  for (const auto &body : bodies)
    stiffness_.push_back(pair_stiffness(*body, factor));
}

double ShortRangeContact::stiffness(const int body, const int other_body) const
{
  const double k = stiffness_[body], k2 = stiffness_[other_body];
  return body == other_body ? k : 2. * k * k2 / (k + k2);
}

double ShortRangeContact::squared_frequency(const PeridynamicBody &body) const
{
  // Two neighbours in antiphase double the stiffness.
  return 2. * crowd * pair_stiffness(body, factor_) / body.point_mass();
}

void ShortRangeContact::add_forces(const double dt)
{
  if (factor_ <= 0.)
    return;
  pairs_.update(dt);
  contacts_.clear();
  rubbed_.clear();
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    push_former_neighbours(body, dt);
  push_non_bonded_pairs(dt);
}

void ShortRangeContact::push_former_neighbours(const std::size_t body, const double dt)
{
  using Pair             = BrokenBondPairs::Pair;
  const auto &list       = pairs_.broken_bond_pairs(body);
  const auto &a          = bodies_[body]->state().arrays;
  const Lattice &l       = bodies_[body]->lattice();
  const std::ptrdiff_t n = find_touching(
      list,
      [&a](const Pair &pair)
      {
        return is_touch((at(a.position, pair.q) - at(a.position, pair.p)).squaredNorm(),
                        pair.distance);
      },
      [](const Pair &one, const Pair &other)
      { return std::tie(one.p, one.q) < std::tie(other.p, other.q); },
      touching_);
  const auto end = [&](const std::int32_t p) {
    return Follower{l.owned(p) ? p : -1, static_cast<std::int16_t>(body), false};
  };
  for (std::ptrdiff_t i = 0; i < n; ++i)
  {
    const auto &[p, q, distance] = list.pairs[touching_[i]];
    push({end(p), end(q), at(a.position, q) - at(a.position, p),
          at(a.velocity, q) - at(a.velocity, p), distance, stiffness_[body],
          0.5 * bodies_[body]->point_mass()},
         dt);
  }
}

void ShortRangeContact::push_non_bonded_pairs(const double dt)
{
  using Pair             = ContactPairs::NonBondedPair;
  const auto &list       = pairs_.non_bonded_pairs();
  const auto &watched    = pairs_.watched();
  const std::ptrdiff_t n = find_touching(
      list,
      [&](const Pair &pair)
      {
        const auto &a = watched[pair.a], &b = watched[pair.b];
        return is_touch((vector(b.position) - vector(a.position)).squaredNorm(), pair.distance) &&
               (!pair.one_body || a.damaged + b.damaged > 0.);
      },
      [&](const Pair &one, const Pair &other)
      {
        const auto ids = [&](const Pair &pair)
        { return std::make_pair(watched.id(pair.a), watched.id(pair.b)); };
        return ids(one) < ids(other);
      },
      touching_);
  const auto end = [&](const std::int32_t number)
  {
    Follower follower = watched.follower(number);
    if (follower.image)
      follower.flat = -1; // moves as its original does
    return follower;
  };
  for (std::ptrdiff_t i = 0; i < n; ++i)
  {
    const auto &pair = list.pairs[touching_[i]];
    const auto &a = watched[pair.a], &b = watched[pair.b];
    const Follower first = end(pair.a), second = end(pair.b);
    const double m = bodies_[first.body]->point_mass(), m2 = bodies_[second.body]->point_mass();
    push({first, second, vector(b.position) - vector(a.position),
          vector(b.velocity) - vector(a.velocity), pair.distance,
          stiffness(first.body, second.body), m * m2 / (m + m2)},
         dt);
  }
}

/// Adds the forces of two points that touch.
void ShortRangeContact::push(const ActiveContact &touch, const double dt)
{
  const double r       = std::sqrt(touch.apart.squaredNorm());
  const double overlap = touch.distance - r;
  Vector3 force        = touch.stiffness * overlap / r * touch.apart;
  Vector3 along        = Vector3::Zero();
  if (friction_.law)
  {
    along = friction(touch.apart / r, touch.velocity, touch.stiffness * overlap, touch.mass, dt);
    force += along;
  }
  for (const auto &[end, sign] : {std::pair<const Follower &, double>{touch.first, -1.},
                                  std::pair<const Follower &, double>{touch.second, 1.}})
    if (end.flat >= 0)
    {
      auto &a = bodies_[end.body]->state().arrays;
      for (int d = 0; d < 3; ++d)
        a.force[d][end.flat] += sign * force[d];
      if (friction_.law)
        rubbed_.push_back({end.flat, end.body, sign * along, at(a.velocity, end.flat)});
    }
  contacts_.push_back({touch.first, touch.second, 0.5 * touch.stiffness * overlap * overlap});
}

/// Force of friction on the second of two points.
///
/// @param normal    From the first to the second, of length 1.
/// @param velocity  Of the second relative to the first [m/s].
/// @param pressure  The normal force f_n [N].
/// @param mass      Reduced mass of the two [kg].
Vector3 ShortRangeContact::friction(const Vector3 &normal, const Vector3 &velocity,
                                    const double pressure, const double mass, const double dt) const
{
  const Vector3 sliding = velocity - velocity.dot(normal) * normal;
  const double speed    = sliding.norm();
  const double drag     = friction_.factor * friction_.law->coefficient(speed) * pressure /
                      std::max(speed, friction_.regularisation_speed);
  // Friction stops two points but never drives them back: an impact presses points together so hard
  // that one step of Coulomb's force would reverse their sliding, and the next one again. All
  // neighbours of a point together stop it in one step at the most, one alone takes some.
  return -std::min(drag, mass / (crowd * dt)) * sliding;
}

void ShortRangeContact::record_work(const double dt)
{
  for (const auto &point : rubbed_)
  {
    // The mean of the velocities before and after the kick gives the exact work of the scheme.
    const Vector3 after = at(bodies_[point.body]->state().arrays.velocity, point.point);
    work_[bodies_[point.body]->lattice().plane_of(point.point)][0] +=
        0.5 * dt * point.force.dot(point.velocity + after);
  }
}

double ShortRangeContact::friction_work() const
{
  return friction_.law ? (mirrored_ ? 2. : 1.) * work_.total(communicator_)[0] : 0.;
}

double ShortRangeContact::energy() const
{
  PlaneSums<1> sums(most_planes(bodies_));
  for (const auto &contact : contacts_)
    for (const auto *const end : {&contact.first, &contact.second})
      if (end->flat >= 0)
        sums[bodies_[end->body]->lattice().plane_of(end->flat)][0] += 0.5 * contact.energy;
  return (mirrored_ ? 2. : 1.) * sums.total(communicator_)[0];
}

double ShortRangeContact::n_touching() const
{
  double n = 0.;
  for (const auto &contact : contacts_)
    n += 0.5 * (contact.first.flat >= 0) + 0.5 * (contact.second.flat >= 0);
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return n;
}
} // namespace ricochet
