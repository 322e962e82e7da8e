// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/short_range_contact.h"

#include "ricochet/base/phase_clock.h"

#include "contact_pairs.h"
#include "field_values.h"
#include "ricochet/contact/pair_law.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ricochet
{
namespace
{
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

/// Points at the same place do not touch: there is no direction to push them apart.
bool is_touching(const double squared, const double distance)
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
  pairs_(std::make_unique<ContactPairs>(communicator, bodies_, mirrored, search))
{
  for (const auto &body : bodies)
  {
    stiffness_.push_back(pair_stiffness(*body, factor));
    work_.emplace_back(body->lattice().box().n[0]);
  }
}

ShortRangeContact::~ShortRangeContact() = default;

void ShortRangeContact::bodies_changed()
{
  pairs_->bodies_changed();
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    work_[body].move_home(*bodies_[body]);
}

void ShortRangeContact::exchange_state(StateArchive &archive)
{
  // Which pairs there are follows from where the points are, and from their bonds.
  for (std::size_t body = 0; body < bodies_.size(); ++body)
  {
    const StateArchive::Group group(archive, "debris of plate " + std::to_string(body + 1));
    work_[body].exchange_state(archive, *bodies_[body]);
  }
}

void ShortRangeContact::record_work(const double dt)
{
  const PhaseClock::Work phase(Phase::debris);
  for (auto &work : work_)
    work.record(dt);
}

long ShortRangeContact::n_searches() const
{
  return pairs_->n_searches();
}

long ShortRangeContact::n_single_searches() const
{
  return pairs_->n_single_searches();
}

double ShortRangeContact::stiffness(const int body, const int other_body) const
{
  const double k = stiffness_[body], k2 = stiffness_[other_body];
  return body == other_body ? k : 2. * k * k2 / (k + k2);
}

double ShortRangeContact::squared_frequency(const PeridynamicBody &body) const
{
  // Two neighbours in antiphase double the stiffness.
  return 2. * contacts_of_a_point * pair_stiffness(body, factor_) / body.point_mass();
}

void ShortRangeContact::add_forces(const double dt)
{
  const PhaseClock::Work phase(Phase::debris);
  if (factor_ <= 0.)
    return;
  pairs_->update(dt);
  energies_.clear();
  for (auto &work : work_)
    work.clear();
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    add_broken_bond_forces(body, dt);
  add_non_bonded_forces(dt);
}

void ShortRangeContact::add_broken_bond_forces(const std::size_t body, const double dt)
{
  using Pair             = BrokenBondPairs::Pair;
  const auto &list       = pairs_->broken_bond_pairs(body);
  const auto &a          = bodies_[body]->state().arrays;
  const Lattice &l       = bodies_[body]->lattice();
  const std::ptrdiff_t n = find_touching(
      list,
      [&a](const Pair &pair)
      {
        return is_touching((at(a.position, pair.q) - at(a.position, pair.p)).squaredNorm(),
                           pair.distance);
      },
      [](const Pair &one, const Pair &other)
      { return std::tie(one.p, one.q) < std::tie(other.p, other.q); },
      touching_);
  const auto end = [&](const std::int32_t p) {
    return End{l.owned(p) ? p : -1, static_cast<int>(body)};
  };
  for (std::ptrdiff_t i = 0; i < n; ++i)
  {
    const auto &[p, q, distance] = list.pairs[touching_[i]];
    add_pair_forces({end(p), end(q), at(a.position, q) - at(a.position, p),
                     at(a.velocity, q) - at(a.velocity, p), distance, stiffness_[body],
                     0.5 * bodies_[body]->point_mass()},
                    dt);
  }
}

void ShortRangeContact::add_non_bonded_forces(const double dt)
{
  using Pair             = ContactPairs::NonBondedPair;
  const auto &list       = pairs_->non_bonded_pairs();
  const auto &ghosts     = pairs_->ghosts();
  const std::ptrdiff_t n = find_touching(
      list,
      [&](const Pair &pair)
      {
        const auto &a = ghosts[pair.a], &b = ghosts[pair.b];
        return is_touching((vector(b.position) - vector(a.position)).squaredNorm(),
                           pair.distance) &&
               (!pair.one_body || a.open + b.open > 0.);
      },
      [&](const Pair &one, const Pair &other)
      {
        const auto ids = [&](const Pair &pair)
        { return std::make_pair(ghosts.id(pair.a), ghosts.id(pair.b)); };
        return ids(one) < ids(other);
      },
      touching_);
  const auto end = [&](const std::int32_t number)
  {
    const auto &source = ghosts.source(number);
    return End{source.image ? -1 : source.flat, source.body}; // an image moves as its original
  };
  for (std::ptrdiff_t i = 0; i < n; ++i)
  {
    const auto &pair = list.pairs[touching_[i]];
    const auto &a = ghosts[pair.a], &b = ghosts[pair.b];
    const End first = end(pair.a), second = end(pair.b);
    const double m = bodies_[first.body]->point_mass(), m2 = bodies_[second.body]->point_mass();
    add_pair_forces({first, second, vector(b.position) - vector(a.position),
                     vector(b.velocity) - vector(a.velocity), pair.distance,
                     stiffness(first.body, second.body), m * m2 / (m + m2)},
                    dt);
  }
}

void ShortRangeContact::add_pair_forces(const ActiveContact &contact, const double dt)
{
  const PairLaw<double> pair_law{contact.stiffness, /*shank_force=*/0.,
                                 friction_.regularisation_speed};
  const double r      = std::sqrt(contact.apart.squaredNorm());
  const double depth  = contact.distance - r;
  const double normal = pair_law.normal_force(depth);
  Vector3 force       = normal / r * contact.apart; // on the second
  Vector3 friction    = Vector3::Zero();
  if (friction_.law)
  {
    const Vector3 sliding = sliding_velocity(contact.velocity, Vector3(contact.apart / r));
    const double speed    = sliding.norm();
    const double full     = friction_.factor * friction_.law->coefficient(speed) * normal;
    // All contacts of a point together stop it in one step at the most, one alone takes some.
    friction = -pair_law.resistance(speed, full, contacts_of_a_point / contact.mass, dt) * sliding;
    force += friction;
  }
  for (const auto &[end, sign] : {std::pair<const End &, double>{contact.first, -1.},
                                  std::pair<const End &, double>{contact.second, 1.}})
    if (end.flat >= 0)
    {
      auto &a = bodies_[end.body]->state().arrays;
      for (int d = 0; d < 3; ++d)
        a.force[d][end.flat] += sign * force[d];
      if (friction_.law)
        work_[end.body].add(*bodies_[end.body], end.flat, sign * friction);
    }
  energies_.push_back({contact.first, contact.second, pair_law.energy(depth)});
}

double ShortRangeContact::friction_work() const
{
  double sum = 0.;
  for (const auto &work : work_)
    sum += work.total(communicator_);
  return (mirrored_ ? 2. : 1.) * sum;
}

double ShortRangeContact::energy() const
{
  PlaneSums<1> sums(most_planes(bodies_));
  for (const auto &pair : energies_)
    for (const auto *const end : {&pair.first, &pair.second})
      if (end->flat >= 0)
        sums[bodies_[end->body]->lattice().plane_of(end->flat)][0] += 0.5 * pair.energy;
  return (mirrored_ ? 2. : 1.) * sums.total(communicator_)[0];
}

double ShortRangeContact::n_touching() const
{
  double n = 0.;
  for (const auto &pair : energies_)
    n += 0.5 * (pair.first.flat >= 0) + 0.5 * (pair.second.flat >= 0);
  MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return n;
}
} // namespace ricochet
