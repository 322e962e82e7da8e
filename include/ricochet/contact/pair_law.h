// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one pair in contact: numbers in, numbers out. The loops that visit the pairs are
// contact/rigid_contact.h, contact/surface_contact.h and contact/short_range_contact.h.
//
//   normal    f_n = k d,  E = k d^2/2       d = depth, how far the two are in each other
//   friction  f_t = -mu f_n v_t/|v_t|       Coulomb; v_t = relative velocity across the normal
//   shank     f_s = -mu S v_t/|v_t|         S = fraction times A dx^2, the pressure A of a cavity
//                                           that the target closes behind a projectile's nose
// where v_t/|v_t| becomes v_t/v_reg below the regularisation speed: a force that does not jump with
// its sign. f_n = -dE/d(gap), gap = -d, so normal forces conserve energy; friction never gives any.
#pragma once

#include <algorithm>

namespace ricochet
{
/// Contacts that a point has at once in compact debris: the neighbours at the distance of one
/// spacing in the cubic lattice that the debris comes from. An assumption, no bound: the densest
/// packing has twelve.
constexpr double contacts_of_a_point = 6.;

/// `Number`: double, or one that carries derivatives.
template <class Number>
struct PairLaw
{
  Number stiffness;            // k [N/m]
  Number shank_force;          // S [N]
  Number regularisation_speed; // v_reg [m/s], > 0 where there is friction

  /// f_n: pushes the two apart; `depth` >= 0 [m]. [N]
  Number normal_force(const Number &depth) const { return stiffness * depth; }

  /// Stored in the spring of the pair [J].
  Number energy(const Number &depth) const { return 0.5 * normal_force(depth) * depth; }

  /// Size of Coulomb's force at full sliding; `mu` is the coefficient at the present speed. [N]
  Number friction_limit(const Number &mu, const Number &normal_force) const
  {
    return mu * normal_force;
  }

  /// The same of the shank [N].
  Number shank_limit(const Number &mu) const { return mu * shank_force; }

  /// What the sliding velocity is divided by; `speed` = |v_t| [m/s].
  Number regularised(const Number &speed) const
  {
    using std::max;
    return max(speed, regularisation_speed);
  }

  /// Direction of friction, -v_t/|v_t|; shorter than 1 below the regularisation speed.
  template <class Vector>
  Vector direction(const Vector &sliding, const Number &speed) const
  {
    return -sliding / regularised(speed);
  }

  /// Friction of two free points by their sliding velocity [N]. It stops them but never drives them
  /// back: an impact presses points together so hard that one step of Coulomb's force would reverse
  /// their sliding, and the next one again. All contacts of a point together stop it in one step at
  /// the most, one alone takes some.
  ///
  /// @param sliding       Velocity of the one relative to the other, across the normal [m/s].
  /// @param mu            Coefficient of friction at that speed [-].
  /// @param normal_force  f_n [N].
  /// @param mass          Reduced mass of the two [kg].
  /// @param dt            The coming kick [s].
  template <class Vector>
  Vector bounded_friction(const Vector &sliding, const Number &mu, const Number &normal_force,
                          const Number &mass, const Number &dt) const
  {
    using std::min;
    const Number resistance =
        friction_limit(mu, normal_force) / regularised(sliding.norm()); // [N s/m]
    return -min(resistance, largest_resistance(mass, dt)) * sliding;
  }

  /// Beyond it friction might drive two points back [N s/m].
  static Number largest_resistance(const Number &mass, const Number &dt)
  {
    return mass / (contacts_of_a_point * dt);
  }
};

/// The part of a pair's relative velocity across its normal, which has length 1.
template <class Vector>
Vector sliding_velocity(const Vector &velocity, const Vector &normal)
{
  return velocity - velocity.dot(normal) * normal;
}

/// Work of a force on what it moves, in a step of the leapfrog scheme [J]: with the mean of the
/// velocities before and after the kick, that is exactly the kinetic energy which the force adds.
/// Of friction it is minus the heat.
template <class Vector>
double work_of_step(const Vector &force, const Vector &before, const Vector &after, const double dt)
{
  return 0.5 * dt * force.dot(before + after);
}
} // namespace ricochet
