// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one pair in contact: numbers in, numbers out. The loops that visit the pairs are
// contact/rigid_contact.h, contact/surface_contact.h and contact/short_range_contact.h.
//
//   normal    f_n = k d,  E = k d^2/2       d = depth, how far the two are in each other
//   friction  f_t = -mu f_n v_t/|v_t|       Coulomb; v_t = relative velocity across the normal
//   shank     f_s = -mu s v_t/|v_t|         s = what the target's flow adds to f_n on a shank: up
//                                           to S = fraction times A dx^2, see shank_push()
// where v_t/|v_t| becomes v_t/v_reg below the regularisation speed: a force that does not jump with
// its sign. f_n = -dE/d(gap), gap = -d, so normal forces conserve energy. Friction never gives any:
// its resistance, force over v_t, is bounded by what stops the sliding within a step.
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

  /// What the target's flow adds to the normal force on a shank, for friction alone [N]. A cavity
  /// closes on a shank where the target yields, at the pressure A: nothing where the points push
  /// more gently than S, all of S where they push twice as hard, linear between. So a rod that
  /// lands softly on its side feels Coulomb's law and nothing else.
  Number shank_push(const Number &normal_force) const
  {
    using std::max;
    using std::min;
    return max(Number(0.), min(shank_force, Number(normal_force - shank_force)));
  }

  /// What the sliding velocity is divided by; `speed` = |v_t| [m/s].
  Number regularised(const Number &speed) const
  {
    using std::max;
    return max(speed, regularisation_speed);
  }

  /// Friction is minus this times the sliding velocity [N s/m]. It stops two bodies but never
  /// drives them back: an impact presses points so hard that one step of Coulomb's force would
  /// reverse their sliding, and the next one again.
  ///
  /// @param speed       |v_t| [m/s].
  /// @param full        Size of the force at full sliding: mu times the normal force [N].
  /// @param compliance  Change of the sliding velocity by an impulse of friction, with all that
  /// acts
  ///                    at once; an upper bound will do [1/kg].
  /// @param dt          The coming kick [s]; 0: no bound.
  Number resistance(const Number &speed, const Number &full, const Number &compliance,
                    const Number &dt) const
  {
    using std::min;
    const Number coulomb = full / regularised(speed);
    return dt > 0. ? min(coulomb, Number(1. / (compliance * dt))) : coulomb;
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
