// SPDX-License-Identifier: LGPL-2.1-or-later
// A rigid body of revolution with six degrees of freedom: centre, orientation (quaternion), linear
// velocity and angular momentum, advanced by the leapfrog scheme of the points; with a symmetry
// plane y = 0 it keeps to that plane.
#pragma once

#include "ricochet/base/state_archive.h"
#include "ricochet/geometry/body_of_revolution.h"

#include <Eigen/Geometry>

namespace ricochet
{
/// Of translation, then rotation.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

class RigidBody
{
public:
  /// Place, attitude and their rates.
  struct Motion
  {
    Vector3 position;               // of the centroid [m]
    Vector3 velocity;               // at the half step [m/s]
    Eigen::Quaterniond orientation; // from body axes to space
    Vector3 spin;                   // angular velocity at the half step, in space [rad/s]
  };

  /// `mass` in kg, > 0. `planar`: motion in the plane y = 0 only.
  RigidBody(const BodyOfRevolution &body, double mass, const Motion &start, bool planar);
  /// The same of a body that is no perfect one of revolution: its moments of inertia about the body
  /// axes, which are principal ones [kg m^2].
  RigidBody(const BodyOfRevolution &body, double mass, const Vector3 &inertia, const Motion &start,
            bool planar);

  /// From now on it keeps its velocity and angular momentum, whatever acts on it.
  void drive() { driven_ = true; }
  bool is_driven() const { return driven_; } // see drive()

  /// Kick then drift: force [N] and moment about the centroid [N m], dt in s. The spin of the half
  /// step is found from the angular momentum with the orientation of the half step, found
  /// from that spin: torque-free motion keeps the momentum exactly, and a body of revolution its
  /// energy.
  void advance(const Vector3 &force, const Vector3 &moment, double kick, double drift);

  /// The motion with the velocities of the present time instead of half a step before: half a kick
  /// on. Arguments as for advance().
  Motion present_motion(const Vector3 &force, const Vector3 &moment, double kick) const;
  /// L with L L^T = the change of velocity and spin by an impulse and its moment about the centroid
  /// [kg^-1/2, kg^-1/2 m^-1]; without what a planar motion may not do; zero if driven.
  Matrix6 root_of_mobility() const;

  /// Saves or restores the motion.
  void exchange_state(StateArchive &archive);

  const BodyOfRevolution &body() const { return body_; }                  // its shape
  const Motion &motion() const { return motion_; }                        // at present
  double mass() const { return mass_; }                                   // [kg]
  Vector3 axis() const { return motion_.orientation * Vector3::UnitX(); } // towards the tip
  Vector3 angular_momentum() const { return angular_momentum_; } // about the centroid [kg m^2/s]

  /// Velocity of the body's material at a point of space [m/s].
  Vector3 velocity_at(const Vector3 &point) const
  {
    return motion_.velocity + motion_.spin.cross(point - motion_.position);
  }
  /// Signed distance, outward normal (in space) and surface at a point of space [m].
  BodyOfRevolution::Hit hit(const Vector3 &point) const;
  /// Lowest and highest corner of a box around the body, in space [m]. A curved nose is cut
  /// into 200 slices: less than 2e-5 diameters too small.
  std::pair<Vector3, Vector3> bounding_box() const;

private:
  Vector3 spin_from_momentum(const Eigen::Quaterniond &orientation,
                             const Vector3 &angular_momentum) const;
  /// Removes what a planar motion may not do.
  void restrict(Vector3 &linear, Vector3 &angular) const;

  BodyOfRevolution body_;
  double mass_;
  Vector3 inertia_; // about the body axes [kg m^2]
  bool planar_, driven_ = false;
  Motion motion_;
  Vector3 angular_momentum_;
};
} // namespace ricochet
