// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/peridynamic_body.h"

#include "fracture_energy.h"
#include "point_sums.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/phase_clock.h"
#include "stretched_points.h"

#include <string>
#include <utility>

namespace ricochet
{
namespace
{
const LatticeKernel *kernel_for(const BondLaw &law, const char *instruction_set)
{
  const LatticeKernel *const kernel = lattice_kernel(law.index, instruction_set);
  if (kernel == nullptr)
    throw InputError(std::string("This processor does not have the instruction set '") +
                     instruction_set + "'.");
  return kernel;
}
} // namespace

PeridynamicBody::PeridynamicBody(const MPI_Comm communicator, const int number,
                                 const Lattice::Box &box, const Stencil &stencil,
                                 const PeridynamicMaterial &material, const Lattice::Mask &mask,
                                 const char *instruction_set, const Zone *zone) :
  communicator_(communicator),
  number_(number), lattice_(box, stencil, rank_in(communicator), size_of(communicator), mask, zone),
  state_(lattice_, material.cracks_push), material_(material),
  halo_(communicator, lattice_, number), kernel_(kernel_for(*material.law, instruction_set)),
  tables_(lattice_, material), mass_(material.density * tables_.family().volume),
  damage_(lattice_, state_, *kernel_), fracture_(std::make_unique<FractureEnergy>(*this)),
  stretched_points_(std::make_unique<StretchedPoints>(lattice_))
{
  find_blocks();
}

PeridynamicBody::~PeridynamicBody() = default;

void PeridynamicBody::find_blocks()
{
  blocks_ = find_bond_blocks(lattice_, damage_.sound_bonds(), state_.arrays.half_weight);
}

double PeridynamicBody::sever(const std::function<bool(const Vector3 &, const Vector3 &)> &crosses)
{
  double n_ends = damage_.sever(state_, crosses);
  MPI_Allreduce(MPI_IN_PLACE, &n_ends, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return n_ends;
}

void PeridynamicBody::scale_energy(const std::vector<double> &factor)
{
  state_.scale_weights(lattice_, factor);
  find_blocks();
}

std::vector<std::ptrdiff_t>
PeridynamicBody::points_stretched(const double stretch,
                                  const std::vector<Lattice::BlockRange> &blocks)
{
  return stretched_points_->find(*kernel_, tables_, state_.arrays, lattice_.size(), stretch,
                                 blocks);
}

void PeridynamicBody::start_relaxation(const double dt)
{
  history_.reset();
  start_flow(dt);
  if (material_.relaxation.empty())
    return;
  if (kernel_->relaxing_force == nullptr)
    throw InputError(std::string("The bond model '") + material_.law->name +
                     "' has no shear modulus of its own that could relax. Use 'linear peridynamic "
                     "solid' or leave out the relaxation times.");
  check_series(material_.relaxation);
  check_step(material_.relaxation, dt);
  history_ =
      std::make_unique<BondViscosity>(lattice_, tables_.family(), tables_.unbreakable_constants(),
                                      material_.relaxation, material_.history_precision, dt);
}

void PeridynamicBody::start_flow(const double dt)
{
  flow_.reset();
  if (!material_.flow.flows())
    return;
  if (!material_.law->has_dilatation)
    throw InputError(std::string("The bond model '") + material_.law->name +
                     "' has no shear modulus of its own that could yield. Use 'linear peridynamic "
                     "solid' or leave out the flow stress.");
  if (!material_.relaxation.empty())
    throw InputError("A material that relaxes cannot flow as well. Leave out the relaxation times "
                     "or the flow stress.");
  flow_ = std::make_unique<BondFlow>(lattice_, state_.arrays, tables_.family(), material_.flow, dt);
}

void PeridynamicBody::update_ghosts()
{
  const PhaseClock::Work work(Phase::points);
  auto &a = state_.arrays;
  halo_.exchange(
      {a.position[0], a.position[1], a.position[2], a.velocity[0], a.velocity[1], a.velocity[2]});
  state_.mirror_motion(lattice_);
}

void PeridynamicBody::break_bonds()
{
  const PhaseClock::Work work(Phase::points);
  compute_dilatation(tables_.breakable());
  damage_.mark_damaged();
  has_dilatation_ = true;
}

void PeridynamicBody::book_fracture(const double dt)
{
  const PhaseClock::Work work(Phase::points);
  fracture_->record(dt);
}

/// Bonds that `table` says to break do so, and the others add up to theta, or w theta of points
/// that have a weight.
void PeridynamicBody::compute_dilatation(const BondTable &table)
{
  // Bonds between a ghost and an owned point are visited on both ranks: the sums of owned points
  // are then complete, and made in the same order as on one rank, without sending anything home.
  auto &a  = state_.arrays;
  in_step_ = true;
  if (history_)
    history_->begin(a);
  if (flow_)
    flow_->begin(state_);
  state_.zero(lattice_, a.theta);
  auto &log = damage_.log();
  log.clear();
  for (const auto &range : blocks_.all)
    log.add(*kernel_, a, table, range);
  if (!material_.law->has_dilatation)
    return;
  state_.weigh(lattice_, a.theta);
  if (history_)
    history_->close_theta(a, log);
  double *const shared = history_ ? history_->volumetric() : a.theta;
  halo_.exchange({shared});
  state_.mirror(lattice_, shared);
}

void PeridynamicBody::compute_internal_forces(const ForceRequest &request)
{
  const PhaseClock::Work work(Phase::points);
  if (!std::exchange(has_dilatation_, false))
    compute_dilatation(tables_.unbreakable());
  if (flow_ && request.is_step)
    flow_->step(*kernel_, tables_.breakable(), state_, blocks_, halo_);
  for (double *f : state_.arrays.force)
    state_.zero(lattice_, f);
  if (history_)
    add_relaxing_forces(request);
  else
    add_bond_forces(request.energy);
}

void PeridynamicBody::add_bond_forces(const bool energy)
{
  auto &a = state_.arrays;
  if (energy)
    state_.zero(lattice_, a.energy);
  const auto add_with = [&](const auto loop, const std::vector<Lattice::BlockRange> &ranges)
  {
    for (const auto &range : ranges)
      loop(a, tables_.breakable(), range.first, range.last);
  };
  const auto &k = *kernel_;
  add_with(energy ? k.force_and_energy : k.force, blocks_.whole);
  add_with(energy ? k.weighted_force_and_energy : k.weighted_force, blocks_.weighted);
}

void PeridynamicBody::add_relaxing_forces(const ForceRequest &request)
{
  auto &a            = state_.arrays;
  const bool measure = request.energy || history_->measurement_is_due();
  const auto bonds   = history_->bonds(request.is_step);
  if (measure)
  {
    state_.zero(lattice_, a.energy);
    state_.zero(lattice_, bonds.dissipated);
  }
  const auto add_with = [&](const auto loop, const std::vector<Lattice::BlockRange> &ranges)
  {
    for (const auto &range : ranges)
      loop(a, tables_.breakable(), bonds, range.first, range.last);
  };
  const auto &k = *kernel_;
  add_with(measure ? k.relaxing_force_and_energy : k.relaxing_force, blocks_.whole);
  add_with(measure ? k.weighted_relaxing_force_and_energy : k.weighted_relaxing_force,
           blocks_.weighted);
  history_->end(a, measure, request.is_step);
}

void PeridynamicBody::advance(const double kick, const double drift)
{
  const PhaseClock::Work work(Phase::points);
  for (const auto &range : lattice_.owned_ranges())
    kernel_->advance(state_.arrays, range.first, range.last, kick / mass_, drift);
  end_step();
}

void PeridynamicBody::end_step()
{
  if (std::exchange(in_step_, false))
    std::swap(state_.arrays.theta, state_.arrays.theta_before);
}

Energies PeridynamicBody::energies(const double dt) const
{
  const auto points = point_energies(communicator_, lattice_, state_.arrays, mass_, dt);
  Energies energies;
  energies.kinetic  = points.kinetic;
  energies.strain   = points.strain;
  energies.viscous  = history_ ? history_->dissipated(communicator_) : 0.;
  energies.plastic  = flow_ ? flow_->dissipated(communicator_) : 0.;
  energies.fracture = fracture_->total(communicator_).energy;
  return energies;
}

Momenta PeridynamicBody::momenta() const
{
  return point_momenta(communicator_, lattice_, state_.arrays, mass_);
}

void PeridynamicBody::rest()
{
  state_.rest(lattice_);
  update_ghosts();
  state_.zero(lattice_, state_.arrays.theta);
  state_.zero(lattice_, state_.arrays.theta_before);
}

std::string PeridynamicBody::first_not_finite() const
{
  return first_point_not_finite(lattice_, state_.arrays);
}

double PeridynamicBody::n_broken_bonds() const
{
  return fracture_->total(communicator_).n_bonds;
}
} // namespace ricochet
