// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/hexahedral_body.h"

#include "hexahedron.h"
#include "ricochet/base/elastic_constants.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/bodies/nearest_rigid_motion.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
constexpr int block_size = 8;

Eigen::Map<const Vector3> at(const std::vector<double> &values, const int node)
{
  return Eigen::Map<const Vector3>(values.data() + 3 * node);
}
} // namespace

HexahedralBody::HexahedralBody(const HexSolid &solid, const FiniteElementMaterial &material,
                               const bool mirrored) :
  HexahedralBody(solid, material, mirrored, Options())
{
}

HexahedralBody::HexahedralBody(const HexSolid &solid, const FiniteElementMaterial &material,
                               const bool mirrored, const Options &options) :
  solid_(solid),
  material_(material), mirrored_(mirrored), kernel_(general_hex_kernel(options.instruction_set)),
  hourglass_stiffness_(options.hourglass_coefficient *
                       youngs_modulus(material.bulk_modulus, material.shear_modulus)),
  shares_(options.shares), position_(3 * solid.nodes.size()), velocity_(position_.size(), 0.),
  force_(position_.size(), 0.), mass_(solid.nodes.size(), 0.), inverse_mass_(position_.size()),
  strain_energy_(solid.cells.size(), 0.), hourglass_energy_(strain_energy_)
{
  if (kernel_ == nullptr)
    throw InputError(std::string("This processor does not have the instruction set '") +
                     options.instruction_set + "'.");
  build_blocks();
  centroid_ = Vector3::Zero();
  for (int node = 0; node < n_nodes(); ++node)
  {
    total_mass_ += mass_[node];
    centroid_ += mass_[node] * solid_.nodes[node];
    for (int d = 0; d < 3; ++d)
      inverse_mass_[3 * node + d] = mass_[node] > 0. ? 1. / mass_[node] : 0.;
    if (mirrored && solid_.nodes[node].y() == 0.)
      inverse_mass_[3 * node + 1] = 0.;
  }
  centroid_ /= total_mass_;
  if (mirrored)
    centroid_.y() = 0.;
  rest();
}

void HexahedralBody::build_blocks()
{
  const std::size_t n = solid_.cells.size();
  blocks_.resize((n + block_size - 1) / block_size);
  for (std::size_t i = 0; i < blocks_.size() * block_size; ++i)
  {
    const auto &corners = solid_.cells[std::min(i, n - 1)];
    auto &block         = blocks_[i / block_size];
    const int lane      = i % block_size;
    const int cell      = static_cast<int>(std::min(i, n - 1));
    const Hexahedron element(solid_, cell, hourglass_stiffness_);
    for (int a = 0; a < 8; ++a)
      block.entry[a][lane] = 3 * corners[a];
    if (i < n)
      for (int a = 0; a < 8; ++a)
        mass_[corners[a]] += material_.density * element.node_volume[a];
    for (int m = 0; m < 7; ++m)
    {
      const Vector3 gradient = element.gradient.transpose() * element.mode.col(m) / 8.;
      for (int d = 0; d < 3; ++d)
      {
        block.gradient[m][d][lane] = gradient[d];
        if (m >= 3)
          block.reference[m - 3][d][lane] = element.reference(d, m - 3);
      }
    }
    block.volume[lane]  = share(cell) * element.volume;
    block.bending[lane] = element.bending;
    block.warping[lane] = element.warping;
  }
}

Eigen::Matrix<double, 24, 24> HexahedralBody::stiffness(const int cell) const
{
  const double mu = material_.shear_modulus;
  return Hexahedron(solid_, cell, hourglass_stiffness_)
      .stiffness(material_.bulk_modulus - 2. / 3. * mu, mu, share(cell));
}

void HexahedralBody::set_motion(const RigidBody::Motion &motion)
{
  for (int node = 0; node < n_nodes(); ++node)
  {
    const Vector3 arm = motion.orientation * (solid_.nodes[node] - centroid_);
    Vector3 x         = motion.position + arm;
    Vector3 v         = motion.velocity + motion.spin.cross(arm);
    if (mirrored_ && inverse_mass_[3 * node + 1] == 0.)
      x.y() = v.y() = 0.;
    for (int d = 0; d < 3; ++d)
    {
      position_[3 * node + d] = x[d];
      velocity_[3 * node + d] = v[d];
    }
  }
}

void HexahedralBody::rest()
{
  for (int node = 0; node < n_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      position_[3 * node + d] = solid_.nodes[node][d];
  std::fill(velocity_.begin(), velocity_.end(), 0.);
  std::fill(force_.begin(), force_.end(), 0.);
}

void HexahedralBody::compute_internal_forces(const ForceRequest &request)
{
  std::fill(force_.begin(), force_.end(), 0.);
  const double mu = material_.shear_modulus, lambda = material_.bulk_modulus - 2. / 3. * mu;
  const HexArrays arrays{position_.data(), force_.data(), strain_energy_.data(),
                         hourglass_energy_.data()};
  const GeneralHexGroup group{blocks_.data(), static_cast<int64_t>(solid_.cells.size()), lambda,
                              mu};
  (request.energy ? kernel_->one_point_and_energy : kernel_->one_point)(arrays, group);
}

void HexahedralBody::advance(const double kick, const double drift)
{
  hex_kernel(kernel_->instruction_set)
      ->advance(position_.data(), velocity_.data(), force_.data(), inverse_mass_.data(),
                static_cast<int64_t>(position_.size()), kick, drift);
}

Energies HexahedralBody::energies(const double dt) const
{
  Energies e;
  for (int node = 0; node < n_nodes(); ++node)
    for (int i = 3 * node; i < 3 * node + 3; ++i)
      e.kinetic +=
          0.5 * mass_[node] * velocity_[i] * (velocity_[i] + dt * force_[i] * inverse_mass_[i]);
  for (std::size_t cell = 0; cell < strain_energy_.size(); ++cell)
  {
    e.strain += strain_energy_[cell];
    e.hourglass += hourglass_energy_[cell];
  }
  return e;
}

Momenta HexahedralBody::momenta() const
{
  Momenta m;
  for (int node = 0; node < n_nodes(); ++node)
  {
    const Vector3 p = mass_[node] * at(velocity_, node);
    m.linear += p;
    m.angular += at(position_, node).cross(p);
  }
  return m;
}

RigidBody::Motion HexahedralBody::rigid_motion(const double kick) const
{
  return nearest_rigid_motion(mass_, solid_.nodes, position_, velocity_after(kick), mirrored_);
}

std::vector<double> HexahedralBody::velocity_after(const double kick) const
{
  auto velocity = velocity_;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    velocity[i] += kick * inverse_mass_[i] * force_[i];
  return velocity;
}

void HexahedralBody::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "hexahedra");
  archive.common("position", position_);
  archive.common("velocity", velocity_);
}
} // namespace ricochet
