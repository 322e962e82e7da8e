// SPDX-License-Identifier: LGPL-2.1-or-later
// What moves by forces: points, elements, both coupled, a rigid projectile. The time integrator
// (dynamics/leapfrog.h) and the balances know bodies and nothing else of them.
//
// A body computes what it is made of; with a mirror plane that is the half y > 0, and everything
// here is of that half, see multiplicity().
#pragma once

#include "ricochet/base/state_archive.h"
#include "ricochet/base/vector.h"
#include "ricochet/bodies/energies.h"
#include "ricochet/bodies/vibration.h"

#include <memory>
#include <string>

namespace ricochet
{
/// Of a body or several.
struct Momenta
{
  Vector3 linear  = Vector3::Zero(); // [kg m/s]
  Vector3 angular = Vector3::Zero(); // about the origin [kg m^2/s]

  /// Entry by entry.
  Momenta &operator+=(const Momenta &other);
};
/// Entry by entry.
Momenta operator*(double factor, const Momenta &momenta);

class Body
{
public:
  virtual ~Body() = default;

  /// 2 if the body is the computed half of one that a mirror plane completes, else 1.
  virtual double multiplicity() const = 0;

  // One step, in the order in which the integrator calls it. All are collective.

  /// Whatever follows the motion without being integrated takes over positions and velocities:
  /// ghosts of other ranks, images in the mirror plane, hanging nodes. Call after every change of
  /// the motion.
  virtual void update_ghosts() {}

  /// What a body must know to prepare for what comes.
  struct Outlook
  {
    double time, dt; // of the present state, and the step that led there [s]
    double front;    // how far the projectile has got along x [m]
  };
  /// Changes what the body is made of where damage comes near, ahead of need. Returns whether
  /// points have appeared or changed their place in memory; ghosts are up to date then, too.
  virtual bool adapt(const Outlook &) { return false; }

  /// Irreversible: what is stretched beyond its limit breaks.
  virtual void break_bonds() {}
  /// Adds what the last break_bonds() set free to the energies; `dt` is the step that led there
  /// [s].
  virtual void book_fracture(double /*dt*/) {}

  /// What the forces are computed for.
  struct ForceRequest
  {
    bool energy  = false; // the stored energies too
    bool is_step = true;  // false: a look between steps, histories of relaxation stay as they are
  };
  /// Overwrites the forces with the internal ones at the present positions.
  virtual void compute_internal_forces(const ForceRequest &request) = 0;
  /// Call when all forces are there, those of contact too: what follows others hands its forces on
  /// to them, and the mass is corrected.
  virtual void complete_forces() {}

  /// Kick and drift: v += f kick/m, x += v drift; both in s, equal but in a first half step.
  virtual void advance(double kick, double drift) = 0;

  /// At the present time, where velocities are those of half a step before: kinetic energy is 1/2 m
  /// v- . v+, which the leapfrog scheme conserves together with the others in a linear system.
  /// After compute_internal_forces() with energies and complete_forces(), before advance().
  virtual Energies energies(double dt) const = 0;
  /// Half a step before the present time.
  virtual Momenta momenta() const            = 0;

  /// From now on the material relaxes, from no history, in steps of dt [s]: every
  /// compute_internal_forces() that is a step moves the history on. Before, and without relaxation,
  /// the body is elastic with the instantaneous moduli. Throws InputError if a branch cannot be
  /// used so.
  virtual void start_relaxation(double /*dt*/) {}
  /// Whether the material relaxes from now on.
  virtual bool relaxes() const { return false; }

  /// For frequency_bound() (dynamics/largest_frequency.h); null if the body is rigid.
  virtual std::unique_ptr<Vibration> vibration() = 0;

  /// Saves or restores all that moves, between steps: after advance() and before the next
  /// update_ghosts(). A body to be restored has been built from the same scene and has made no
  /// step.
  virtual void exchange_state(StateArchive &archive) = 0;

  /// "The velocity of point (1, 2, 3)" if that is not a finite number, the first such of this rank;
  /// empty if all are. Not collective.
  virtual std::string first_not_finite() const = 0;
};
} // namespace ricochet
