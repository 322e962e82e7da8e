// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/modal_body.h"

#include "mass_properties.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
RigidBody rigid_part(const BodyOfRevolution &shape, const HexahedralBody &mesh,
                     const RigidBody::Motion &start)
{
  const MassProperties properties(mesh);
  RigidBody::Motion motion = start;
  motion.orientation       = start.orientation * Eigen::Quaterniond(properties.axes);
  return {shape, properties.mass, properties.inertia, motion, mesh.mirrored()};
}

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double> &values)
{
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}
} // namespace

ModalBody::ModalBody(const BodyOfRevolution &shape, const HexahedralBody &mesh,
                     std::vector<int> nodes, const RigidBody::Motion &start) :
  multiplicity_(mesh.multiplicity()),
  nodes_(std::move(nodes)), reference_(3, nodes_.size()), rigid_(rigid_part(shape, mesh, start)),
  shape_(3 * nodes_.size(), 0), position_(3 * nodes_.size()), velocity_(position_.size()),
  force_(position_.size(), 0.)
{
  const MassProperties properties(mesh);
  principal_ = Eigen::Quaterniond(properties.axes);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Vector3 &X  = mesh.solid().nodes[nodes_[i]];
    reference_.col(i) = properties.axes.transpose() * (X - properties.centre);
    on_plane_.push_back(mesh.mirrored() && X.y() == 0.);
  }
  begin();
}

void ModalBody::set_modes(const FreeModes &modes, const int n)
{
  squared_frequency_ = vector_of(modes.squared_frequency).head(n);
  shape_.resize(3 * nodes_.size(), n);
  const Eigen::Matrix3d to_principal = principal_.conjugate().toRotationMatrix();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int k = 0; k < n; ++k)
      shape_.block<3, 1>(3 * i, k) = to_principal *
                                     vector_of(modes.shape[k]).segment<3>(3 * nodes_[i]) /
                                     std::sqrt(multiplicity_); // phi^T M phi = 1 of the whole
  q_ = rate_ = Eigen::VectorXd::Zero(n);
  begin();
}

/// With new modes. That the sizes of mobilities change a little with the deformation is left out:
/// they are a bound.
void ModalBody::begin()
{
  place();
  update_ghosts();
  root_mobility_.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Eigen::MatrixXd G = root_of_mobility(static_cast<int>(i));
    root_mobility_.push_back(std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(G * G.transpose()).eigenvalues()[2]));
  }
}

Eigen::Matrix3d ModalBody::orientation() const
{
  return (rigid_.motion().orientation * principal_.conjugate()).toRotationMatrix();
}

void ModalBody::place()
{
  const Eigen::Matrix3d R = rigid_.motion().orientation.toRotationMatrix();
  const Eigen::VectorXd u =
      n_modes() > 0 ? Eigen::VectorXd(shape_ * q_) : Eigen::VectorXd::Zero(shape_.rows());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    Eigen::Map<Vector3>(position_.data() + 3 * i) =
        rigid_.motion().position + R * (reference_.col(i) + u.segment<3>(3 * i));
}

void ModalBody::velocities(const RigidBody::Motion &placed, const RigidBody::Motion &moving,
                           const Eigen::VectorXd &rate, std::vector<double> &result) const
{
  const Eigen::Matrix3d R = placed.orientation.toRotationMatrix();
  const Eigen::VectorXd v =
      n_modes() > 0 ? Eigen::VectorXd(shape_ * rate) : Eigen::VectorXd::Zero(shape_.rows());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Vector3 arm = Eigen::Map<const Vector3>(position_.data() + 3 * i) - placed.position;
    Eigen::Map<Vector3>(result.data() + 3 * i) =
        moving.velocity + moving.spin.cross(arm) + R * v.segment<3>(3 * i);
  }
}

void ModalBody::update_ghosts()
{
  velocities(rigid_.motion(), rigid_.motion(), rate_, velocity_);
}

void ModalBody::compute_internal_forces(const ForceRequest &)
{
  std::fill(force_.begin(), force_.end(), 0.);
}

ModalBody::Load ModalBody::load() const
{
  Load load{Vector3::Zero(), Vector3::Zero(), {}};
  const Eigen::Matrix3d to_body = rigid_.motion().orientation.conjugate().toRotationMatrix();
  Eigen::VectorXd in_body(force_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Vector3 f = multiplicity_ * Eigen::Map<const Vector3>(force_.data() + 3 * i);
    const Vector3 arm =
        Eigen::Map<const Vector3>(position_.data() + 3 * i) - rigid_.motion().position;
    load.force += f;
    load.moment += arm.cross(f);
    in_body.segment<3>(3 * i) = to_body * f;
  }
  load.on_mode = -squared_frequency_.cwiseProduct(q_);
  if (n_modes() > 0)
    load.on_mode += shape_.transpose() * in_body;
  if (multiplicity_ == 2.) // what is odd in y cancels against the other half
    load.force.y() = load.moment.x() = load.moment.z() = 0.;
  return load;
}

void ModalBody::advance(const double kick, const double drift)
{
  const Load now = load();
  rate_ += kick * now.on_mode;
  const RigidBody::Motion before = rigid_.motion();
  rigid_.advance(now.force, now.moment, kick, drift);
  // With the arms that the forces had: on these velocities they do their work.
  velocities(before, rigid_.motion(), rate_, velocity_);
  q_ += drift * rate_;
  place();
}

Energies ModalBody::energies(const double dt) const
{
  const Load now      = load();
  const auto &motion  = rigid_.motion();
  const Vector3 after = motion.velocity + dt / rigid_.mass() * now.force;
  Energies e;
  e.kinetic = 0.5 * rigid_.mass() * motion.velocity.dot(after) +
              0.5 * motion.spin.dot(rigid_.angular_momentum() + dt * now.moment) +
              0.5 * rate_.dot(rate_ + dt * now.on_mode);
  e.strain = 0.5 * squared_frequency_.dot(q_.cwiseAbs2());
  return 1. / multiplicity_ * e;
}

Momenta ModalBody::momenta() const
{
  const Vector3 p = rigid_.mass() * rigid_.motion().velocity;
  return 1. / multiplicity_ *
         Momenta{p, rigid_.motion().position.cross(p) + rigid_.angular_momentum()};
}

std::string ModalBody::first_not_finite() const
{
  if (!rigid_.motion().position.allFinite() || !rigid_.motion().velocity.allFinite())
    return "The motion of the projectile";
  for (int k = 0; k < n_modes(); ++k)
    if (!std::isfinite(q_[k]) || !std::isfinite(rate_[k]))
      return "The amplitude of mode " + std::to_string(k + 1) + " of the projectile";
  return "";
}

RigidBody::Motion ModalBody::rigid_motion(const double kick) const
{
  RigidBody::Motion motion = rigid_.motion();
  if (kick != 0.)
  {
    const Load now = load();
    motion         = rigid_.present_motion(now.force, now.moment, 2. * kick); // it takes half of it
  }
  motion.orientation = motion.orientation * principal_.conjugate();
  return motion;
}

std::vector<double> ModalBody::velocity_after(const double kick) const
{
  const Load now = load();
  const auto motion =
      rigid_.present_motion(now.force, now.moment, 2. * kick); // it takes half of it
  std::vector<double> result(velocity_.size());
  velocities(rigid_.motion(), motion, rate_ + kick * now.on_mode, result);
  return result;
}

Eigen::MatrixXd ModalBody::root_of_mobility(const int node) const
{
  const Matrix6 rigid     = rigid_.root_of_mobility();
  const Eigen::Matrix3d R = rigid_.motion().orientation.toRotationMatrix();
  const Vector3 arm =
      Eigen::Map<const Vector3>(position_.data() + 3 * node) - rigid_.motion().position;
  Eigen::MatrixXd root(3, 6 + n_modes());
  for (int k = 0; k < 6; ++k)
    root.col(k) = rigid.col(k).head<3>() + Vector3(rigid.col(k).tail<3>()).cross(arm);
  root.rightCols(n_modes()) = R * shape_.middleRows<3>(3 * node);
  return root;
}

double ModalBody::squared_frequency(const std::vector<double> &stiffness,
                                    const std::vector<Vector3> &direction) const
{
  const Eigen::Index n         = 6 + n_modes();
  Eigen::MatrixXd A            = Eigen::MatrixXd::Zero(n, n);
  A.diagonal().tail(n_modes()) = squared_frequency_;
  const Eigen::Matrix3d R      = orientation();
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Eigen::VectorXd pull =
        root_of_mobility(static_cast<int>(i)).transpose() * (R * direction[i]);
    A += multiplicity_ * stiffness[i] * pull * pull.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly)
      .eigenvalues()[n - 1];
}

std::vector<double> ModalBody::mobility_of_loaded() const
{
  // With W_ab = G_a G_b^T the change of a's velocity by an impulse at b, |W_ab| <= |G_a| |G_b|.
  double sum = 0.;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (Eigen::Map<const Vector3>(force_.data() + 3 * i) != Vector3::Zero()) // and at its image
      sum += (on_plane_[i] ? 1. : multiplicity_) * root_mobility_[i];
  std::vector<double> mobility(root_mobility_);
  for (double &x : mobility)
    x *= sum;
  return mobility;
}

void ModalBody::exchange_state(StateArchive &archive)
{
  rigid_.exchange_state(archive);
  const auto n = static_cast<std::size_t>(n_modes());
  archive.common("modes", q_.data(), n);
  archive.common("rates of modes", rate_.data(), n);
  if (archive.is_restoring())
    place();
}
} // namespace ricochet
