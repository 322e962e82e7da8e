// SPDX-License-Identifier: LGPL-2.1-or-later
// A projectile, rigid or deformable: a body that the plates' points touch.
#pragma once

#include "ricochet/bodies/body.h"
#include "ricochet/contact/rigid_contact.h"
#include "ricochet/output/frame.h"
#include "ricochet/scene/scene.h"

#include <vector>

namespace ricochet
{
class Projectile : public Body
{
public:
  using Motion = RigidBody::Motion; // place, attitude and their rates

  const BodyOfRevolution &body() const { return body_; } // undeformed
  double mass() const { return mass_; }                  // [kg]

  /// Of the whole body; of a deformable one the nearest rigid motion. Velocities are those of half
  /// a step before the present time.
  virtual const Motion &motion() const           = 0;
  /// The same with the velocities of the present time; `dt` as for energies().
  virtual Motion present_motion(double dt) const = 0;
  /// Angle between the axis, seen from the side (along y), and the plates: positive = nose up,
  /// counted on beyond a quarter turn and a full one [rad].
  double pitch() const { return pitch_; }
  /// Lowest and highest corner of a box around the body [m].
  virtual std::pair<Vector3, Vector3> bounding_box() const = 0;
  /// What is drawn of it at present.
  virtual SurfaceFrame surface() const                     = 0;

  /// Adds the forces of contact to the plates' points, all their other forces being there, and to
  /// the body, in the coming kick of dt [s]. Returns what each plate does to the body; collective.
  virtual std::vector<ContactRecord>
  add_contact_forces(const std::vector<PeridynamicBody *> &plates, double dt)       = 0;
  /// As Interaction::bodies_changed().
  virtual void plates_changed(const std::vector<PeridynamicBody *> &plates)         = 0;
  /// As Interaction::exchange_state(): what contact with the plates has booked.
  virtual void exchange_contact_state(StateArchive &archive,
                                      const std::vector<PeridynamicBody *> &plates) = 0;
  /// Books the work of friction on all plates' points in a step, `dt` long [s], after their kick.
  virtual void record_work(double dt)                                               = 0;
  /// Work of friction on body and points so far, both halves; minus the heat [J]. Collective.
  virtual double friction_work() const                                              = 0;

  /// Tells the largest squared frequency of the plates, contact included [1/s^2]: a projectile that
  /// picks what it resolves picks now. Call once, before the first step. Collective.
  virtual void resolve(double /*squared_frequency*/) {}
  /// Largest squared frequency of the body itself, contact springs included; 0 if rigid [1/s^2].
  virtual double squared_frequency() const = 0;
  /// What it is computed as, in words, both halves: "1232 hexahedra"; empty if rigid.
  virtual std::string parts() const        = 0;
  /// More of it, whole lines for `check`.
  virtual std::string description() const { return ""; }
  /// The largest von Mises stress below its surface so far; 0 if it is not known [Pa].
  virtual double largest_von_mises() const { return 0.; }
  /// Measured, of the body's internal forces alone [s].
  virtual double seconds_per_step() const = 0;

protected:
  /// `body`: the undeformed shape; `mass` of the whole [kg].
  Projectile(const BodyOfRevolution &body, const double mass) : body_(body), mass_(mass) {}

  /// Part of exchange_state(): what is told here.
  void exchange_pitch(StateArchive &archive) { archive.common("pitch", pitch_); }
  /// Call when motion() is new, at the start and after every step: turns less than half a turn.
  void follow_pitch();

private:
  BodyOfRevolution body_;
  double mass_;
  double pitch_ = 0.; // [rad]
};

/// What a projectile must know of each plate, from top to bottom.
struct PlateContact
{
  RigidContact::Parameters parameters; // of each pair with one of its points
  double spacing;                      // dx [m]
  int n_planes;                        // of the lattice
};

/// The scene's projectile at its start, its lowest point above the entry point. `law` must outlive
/// it.
std::unique_ptr<Projectile> make_projectile(MPI_Comm communicator, const Scene &scene,
                                            const FrictionLaw &law,
                                            const std::vector<PlateContact> &plates);
} // namespace ricochet
