// SPDX-License-Identifier: LGPL-2.1-or-later
// A free elastic body as a rigid motion and some of its eigenmodes: x = c + R (X + sum_k phi_k q_k)
// in a floating frame with mean axes. The modes carry neither linear nor, to first order, angular
// momentum, so c and R obey the rigid body's equations and each mode its own,
//   q_k'' + omega_k^2 q_k = phi_k^T R^T f,
// integrated by the leapfrog scheme of all other bodies. Moments are about c, with the deformed
// arms: velocities v = c' + w x (x - c) + R phi q' are exactly those on which forces do the work
// that rigid motion and modes receive, and angular momentum is kept to rounding.
//
// Left out: the change of the moments of inertia with q, and what spinning does to the modes
// (Coriolis and centrifugal forces). They are of the order of u/L and (w/omega_1)^2, doc/theory.md.
//
// Of a mesh only the nodes of its surface are followed.
#pragma once

#include "ricochet/finite_elements/free_vibration.h"

namespace ricochet
{
class ModalBody : public Body
{
public:
  /// `mesh`: at its reference configuration, with its masses; `nodes` of it are followed; `shape`
  /// is what RigidBody is told. `start`: of the centroid. Without modes: rigid.
  ModalBody(const BodyOfRevolution &shape, const HexahedralBody &mesh, std::vector<int> nodes,
            const RigidBody::Motion &start);

  /// From now on it has the first n of these modes of the mesh, at rest and not deformed.
  void set_modes(const FreeModes &modes, int n);
  int n_modes() const { return static_cast<int>(squared_frequency_.size()); } // may be 0

  double multiplicity() const override { return multiplicity_; }
  void update_ghosts() override;
  void compute_internal_forces(const ForceRequest &request) override;
  void advance(double kick, double drift) override;
  Energies energies(double dt) const override;
  Momenta momenta() const override;
  std::unique_ptr<Vibration> vibration() override { return nullptr; }
  void exchange_state(StateArchive &archive) override;
  std::string first_not_finite() const override;

  /// With the velocities after a kick of the present forces [s].
  RigidBody::Motion rigid_motion(double kick) const;
  /// Velocities of the followed nodes after a kick of the present forces [s], three numbers each
  /// [m/s].
  std::vector<double> velocity_after(double kick) const;

  /// Largest squared frequency: of the modes, and of all degrees of freedom if springs of so many
  /// N/m pull at the followed nodes along these directions, all at once [1/s^2].
  double squared_frequency(const std::vector<double> &stiffness,
                           const std::vector<Vector3> &direction) const;
  /// The most that impulses of one size at all nodes that forces act on now change each node's
  /// velocity, as SurfaceNodes (contact/surface_contact.h) wants it [1/kg].
  std::vector<double> mobility_of_loaded() const;

  /// Amplitudes of the modes, with the whole body's masses [kg^1/2 m].
  const Eigen::VectorXd &amplitudes() const { return q_; }
  /// Turns vectors of the mesh's frame into space.
  Eigen::Matrix3d orientation() const;

  // Of the followed nodes, three numbers each. The velocity belongs to the half step before the
  // positions, from advance() to update_ghosts() to those that the forces acted at.
  const std::vector<double> &position() const { return position_; } // [m]
  const std::vector<double> &velocity() const { return velocity_; } // [m/s]
  std::vector<double> &force() { return force_; }                   // of this half [N]

private:
  /// What forces do to the whole body.
  struct Load
  {
    Vector3 force, moment;   // about the centroid [N, N m]
    Eigen::VectorXd on_mode; // with the modes' own [kg^1/2 m/s^2]
  };
  Load load() const;
  void begin();
  void place();
  /// Of the nodes where they are, `placed` being the frame's place there, `moving` its rates.
  void velocities(const RigidBody::Motion &placed, const RigidBody::Motion &moving,
                  const Eigen::VectorXd &rate, std::vector<double> &result) const;
  /// Velocities of a node by unit impulses in each degree of freedom, root of its mobility.
  Eigen::MatrixXd root_of_mobility(int node) const;

  double multiplicity_;
  Eigen::Quaterniond principal_; // from principal axes to those of the mesh
  std::vector<int> nodes_;       // in the mesh
  std::vector<char> on_plane_;   // of these, the mirror plane
  Eigen::Matrix3Xd reference_;   // of these about the centroid, in principal axes [m]
  RigidBody rigid_;
  Eigen::VectorXd squared_frequency_;
  Eigen::MatrixXd shape_;    // in principal axes, 3 rows per node [kg^-1/2]
  Eigen::VectorXd q_, rate_; // the rate at the half step
  std::vector<double> position_, velocity_, force_;
  std::vector<double> root_mobility_; // |G| of each node, W_ab = G_a G_b^T [kg^-1/2]
};
} // namespace ricochet
