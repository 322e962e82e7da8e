// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/finite_elements/finite_element_body.h"

#include "absorbing_boundary.h"
#include "consistent_mass.h"
#include "element_groups.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/phase_clock.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace ricochet
{
namespace
{
Vector3 at(const std::vector<double> &values, const int node)
{
  return {values[3 * node], values[3 * node + 1], values[3 * node + 2]};
}
} // namespace

FiniteElementBody::FiniteElementBody(const MPI_Comm communicator, const HexMesh::Box &box,
                                     const FiniteElementMaterial &material) :
  FiniteElementBody(communicator, box, material, Options())
{
}

FiniteElementBody::FiniteElementBody(const MPI_Comm communicator, const HexMesh::Box &box,
                                     const FiniteElementMaterial &material,
                                     const Options &options) :
  communicator_(communicator),
  mesh_(communicator, box), material_(material), kernel_(hex_kernel(options.instruction_set)),
  position_(mesh_.reference()), velocity_(position_.size(), 0.), force_(position_.size(), 0.)
{
  if (kernel_ == nullptr)
    throw InputError(std::string("This processor does not have the instruction set '") +
                     options.instruction_set + "'.");
  elements_ = std::make_unique<ElementGroups>(mesh_, material_, options.quadrature,
                                              options.hourglass_coefficient, *kernel_);
  set_active(options.active);
}

FiniteElementBody::~FiniteElementBody() = default;

void FiniteElementBody::set_active(const std::function<bool(const Vector3 &)> &active)
{
  std::vector<char> is_active;
  for (const auto &element : mesh_.elements())
    is_active.push_back(!active || active(mesh_.centre(element)));
  elements_->set_active(is_active);
  consistent_mass_.reset();
  mass_ = lumped_mass(mesh_, material_.density, is_active, fixed_);
}

void FiniteElementBody::set_stiffness(const std::vector<ElementStiffness> &stiffness)
{
  elements_->set_stiffness(stiffness);
}

void FiniteElementBody::start_relaxation(const double dt)
{
  elements_->start_relaxation(dt);
}

bool FiniteElementBody::relaxes() const
{
  return elements_->relaxes();
}

void FiniteElementBody::set_consistent_mass(const std::vector<int> &elements,
                                            const int points_per_edge)
{
  consistent_mass_ = std::make_unique<ConsistentMass>(communicator_, mesh_, mass_,
                                                      material_.density, elements, points_per_edge);
  consistent_mass_->find_momentum(velocity_);
}

void FiniteElementBody::set_velocity(const std::vector<double> &velocity)
{
  velocity_ = velocity;
  if (consistent_mass_)
    consistent_mass_->find_momentum(velocity_);
}

void FiniteElementBody::rest()
{
  position_ = mesh_.reference();
  std::fill(force_.begin(), force_.end(), 0.);
  set_velocity(std::vector<double>(velocity_.size(), 0.));
}

void FiniteElementBody::fix(const int node, const int component)
{
  if (node >= mesh_.n_owned_nodes())
    return;
  fixed_.push_back(3 * node + component);
  mass_.inverse[3 * node + component] = 0.;
}

void FiniteElementBody::absorb_at(const std::array<bool, 6> &faces)
{
  boundary_ = std::make_unique<AbsorbingBoundary>(mesh_, material_, faces);
}

void FiniteElementBody::update_ghosts()
{
  const PhaseClock::Work work(Phase::elements);
  for (auto *values : {&position_, &velocity_})
  {
    mesh_.update_ghosts(values->data());
    mesh_.follow_masters(values->data());
  }
}

void FiniteElementBody::compute_internal_forces(const ForceRequest &request)
{
  const PhaseClock::Work work(Phase::elements);
  const auto &[energy, is_step] = request;
  std::fill(force_.begin(), force_.end(), 0.);
  elements_->add_forces(position_, force_, energy, is_step);
}

void FiniteElementBody::correct_mass()
{
  const PhaseClock::Work work(Phase::elements);
  if (consistent_mass_)
    consistent_mass_->correct(force_);
}

void FiniteElementBody::advance(const double kick, const double drift)
{
  const PhaseClock::Work work(Phase::elements);
  if (consistent_mass_)
    consistent_mass_->advance(kick);
  if (boundary_)
    boundary_->damp({position_, velocity_, force_, mass_.inverse}, kick, force_);
  kernel_->advance(position_.data(), velocity_.data(), force_.data(), mass_.inverse.data(),
                   static_cast<int64_t>(mass_.inverse.size()), kick, drift);
}

Energies FiniteElementBody::energies(const double dt) const
{
  ExactSum sum_kinetic, sum_absorbed;
  const auto add_kinetic = [&](const int i, const double momentum)
  { sum_kinetic.add(0.5 * momentum * (velocity_[i] + dt * force_[i] * mass_.inverse[i])); };
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    for (int i = 3 * node; i < 3 * node + 3; ++i)
      add_kinetic(i, mass_.mass[node] * velocity_[i]);
  if (consistent_mass_)
    for (std::size_t k = 0; k < consistent_mass_->momentum().size(); ++k)
    {
      const int node = consistent_mass_->nodes()[k / 3], i = 3 * node + static_cast<int>(k % 3);
      add_kinetic(i, consistent_mass_->momentum()[k] - mass_.mass[node] * velocity_[i]);
    }
  if (boundary_)
    boundary_->add_energies({position_, velocity_, force_, mass_.inverse}, mass_.mass, dt,
                            sum_kinetic, sum_absorbed);
  ElementGroups::Energies of_elements;
  elements_->add_energies(of_elements);
  const auto sums =
      totals<5>(communicator_, {sum_kinetic, of_elements.strain, of_elements.hourglass,
                                of_elements.viscous, sum_absorbed});
  Energies e;
  e.kinetic   = sums[0];
  e.strain    = sums[1];
  e.hourglass = sums[2];
  e.viscous   = sums[3];
  e.absorbed  = sums[4];
  return e;
}

double FiniteElementBody::squared_force() const
{
  double sum = 0.;
  for (std::size_t i = 0; i < mass_.inverse.size(); ++i)
    sum += force_[i] * force_[i] * mass_.inverse[i];
  if (consistent_mass_)
    for (std::size_t k = 0; k < consistent_mass_->uncorrected_force().size(); ++k)
    {
      const std::size_t i = 3 * consistent_mass_->nodes()[k / 3] + k % 3;
      sum += (consistent_mass_->uncorrected_force()[k] - force_[i]) * force_[i] * mass_.inverse[i];
    }
  return sum;
}

Vector3 FiniteElementBody::uncorrected_force(const int node) const
{
  if (consistent_mass_)
  {
    const auto &nodes = consistent_mass_->nodes(); // ascending
    const auto found  = std::lower_bound(nodes.begin(), nodes.end(), node);
    if (found != nodes.end() && *found == node)
      return at(consistent_mass_->uncorrected_force(), static_cast<int>(found - nodes.begin()));
  }
  return at(force_, node);
}

Momenta FiniteElementBody::momenta() const
{
  std::array<ExactSum, 6> sums;
  if (boundary_)
    boundary_->add_momenta(sums);
  const auto add = [&](const int node, const Vector3 &linear)
  {
    const Vector3 angular = at(position_, node).cross(linear);
    for (int d = 0; d < 3; ++d)
    {
      sums[d].add(linear[d]);
      sums[3 + d].add(angular[d]);
    }
  };
  std::size_t k           = 0; // of the nodes whose momentum is known
  const std::size_t n_own = consistent_mass_ ? consistent_mass_->nodes().size() : 0;
  for (int node = 0; node < mesh_.n_owned_nodes(); ++node)
    if (k < n_own && consistent_mass_->nodes()[k] == node)
      add(node, at(consistent_mass_->momentum(), static_cast<int>(k++)));
    else
      add(node, mass_.mass[node] * at(velocity_, node));
  const auto p = totals(communicator_, sums);
  return {{p[0], p[1], p[2]}, {p[3], p[4], p[5]}};
}

double FiniteElementBody::total_mass() const
{
  ExactSum sum;
  for (const double mass : mass_.mass)
    sum.add(mass);
  return total(communicator_, sum);
}

bool FiniteElementBody::is_active(const int element) const
{
  return elements_->is_active(element);
}

double FiniteElementBody::strain_energy(const int element) const
{
  return elements_->strain_energy(element);
}

double FiniteElementBody::hourglass_energy(const int element) const
{
  return elements_->hourglass_energy(element);
}

Eigen::Matrix3d FiniteElementBody::back_strain(const int element, const int branch) const
{
  return elements_->back_strain(element, branch);
}

Eigen::Matrix3d FiniteElementBody::history(const int element, const int branch) const
{
  return elements_->history(element, branch);
}

Eigen::Matrix3d FiniteElementBody::deformation_gradient(const int element) const
{
  // dN_a/dX = +-1/(4 h) in the middle
  const auto &e     = mesh_.elements()[element];
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (int corner = 0; corner < 8; ++corner)
    for (int d = 0; d < 3; ++d)
      F.col(d) += ((corner >> d) & 1 ? 1. : -1.) / (4. * e.edge) * at(position_, e.nodes[corner]);
  return F;
}

Eigen::Matrix3d FiniteElementBody::stress(const int element) const
{
  const Eigen::Matrix3d F = deformation_gradient(element);
  return elements_->stress(element, 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity()));
}
} // namespace ricochet
