// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/forces/peridynamic_force.h"

#include "ricochet/base/exceptions.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace ricochet
{
namespace
{
int rank_of(const MPI_Comm communicator)
{
  int rank;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

int size_of(const MPI_Comm communicator)
{
  int size;
  MPI_Comm_size(communicator, &size);
  return size;
}
} // namespace

PeridynamicForce::PeridynamicForce(const MPI_Comm communicator, const int number,
                                   const Lattice::Box &box, const Stencil &stencil,
                                   const PeridynamicMaterial &material, const Lattice::Mask &mask,
                                   const char *instruction_set) :
  communicator_(communicator),
  lattice_(box, stencil, rank_of(communicator), size_of(communicator), mask), state_(lattice_),
  material_(material), halo_(communicator, lattice_, number),
  kernel_(lattice_kernel(material.law->index, instruction_set))
{
  if (kernel_ == nullptr)
    throw InputError(std::string("This processor does not have the instruction set '") +
                     instruction_set + "'.");
  if (material.law->fixes_poisson_ratio &&
      std::abs(material.shear_modulus - 0.6 * material.bulk_modulus) >
          0.01 * material.shear_modulus)
  {
    std::ostringstream message;
    message << "The bond model '" << material.law->name
            << "' has Poisson's ratio 1/4, that is mu = 3K/5 = " << 0.6e-9 * material.bulk_modulus
            << " GPa; the material asks for mu = " << 1e-9 * material.shear_modulus
            << " GPa. Use 'linear peridynamic solid' or change the shear modulus.";
    throw InputError(message.str());
  }

  const FamilyConstants family =
      family_constants(stencil, material.bulk_modulus, material.shear_modulus);
  mass_ = material.density * family.volume;
  for (const auto &offset : stencil.offsets)
  {
    BondConstants c = material.law->bond(family, offset.length, offset.omega);
    c.critical      = std::numeric_limits<double>::infinity();
    unbreakable_constants_.push_back(c);
    c.critical = material.critical_stretch * offset.length;
    constants_.push_back(c);
    shifts_.push_back(lattice_.shift(offset));
  }
  const double point_stiffness = material.law->point_stiffness(family);
  const int n                  = static_cast<int>(constants_.size());
  table_                       = {n, shifts_.data(), constants_.data(), point_stiffness};
  unbreakable_table_ = {n, shifts_.data(), unbreakable_constants_.data(), point_stiffness};

  initial_bonds_.assign(state_.arrays.bonds,
                        state_.arrays.bonds + lattice_.size() / Lattice::block_size * n);
  damaged_.assign(lattice_.size(), 0);
  initial_family_.assign(lattice_.size(), 0);
  for (std::ptrdiff_t p = lattice_.owned_begin(); p < lattice_.owned_end(); ++p)
    if (lattice_.owned(p))
      initial_family_[p] = static_cast<std::uint16_t>(family_size(p, state_.arrays.bonds));
  broken_.resize(lattice_.size() / Lattice::block_size * n);
}

void PeridynamicForce::start_relaxation(const double dt)
{
  history_.reset();
  if (material_.relaxation.empty())
    return;
  if (kernel_->relaxing_force == nullptr)
    throw InputError(std::string("The bond model '") + material_.law->name +
                     "' has no shear modulus of its own that could relax. Use 'linear peridynamic "
                     "solid' or leave out the relaxation times.");
  check_series(material_.relaxation);
  check_step(material_.relaxation, dt);
  history_ = std::make_unique<BondHistory>(
      lattice_,
      family_constants(lattice_.stencil(), material_.bulk_modulus, material_.shear_modulus),
      unbreakable_constants_, material_.relaxation, material_.history_precision, dt);
}

void PeridynamicForce::update_ghosts()
{
  auto &a = state_.arrays;
  halo_.exchange(
      {a.position[0], a.position[1], a.position[2], a.velocity[0], a.velocity[1], a.velocity[2]});
  state_.mirror_motion(lattice_);
}

void PeridynamicForce::evaluate(const bool breaking, const bool energy)
{
  // Bonds between a ghost and an owned point are visited on both ranks: the sums of owned points
  // are then complete, and made in the same order as on one rank, without sending anything home.
  auto &a            = state_.arrays;
  const int64_t last = lattice_.owned_end() / Lattice::block_size;
  const auto &table  = breaking ? table_ : unbreakable_table_;

  if (history_)
    history_->begin(a);
  std::swap(a.theta, a.theta_before);
  state_.zero(a.theta);
  n_broken_ = static_cast<std::size_t>(kernel_->stretch(a, table, 0, last, broken_.data()));
  if (history_)
    history_->close_theta(a, broken_.data(), n_broken_);
  if (material_.law->has_dilatation)
  {
    double *const shared = history_ ? history_->volumetric() : a.theta;
    halo_.exchange({shared});
    state_.mirror(lattice_, shared);
  }
  for (std::size_t i = 0; i < n_broken_; ++i)
    for (int lane = 0; lane < Lattice::block_size; ++lane)
      if ((broken_[i].points >> lane) & 1)
      {
        const std::ptrdiff_t p =
            static_cast<std::ptrdiff_t>(broken_[i].block) * Lattice::block_size + lane;
        damaged_[p] = damaged_[p + shifts_[broken_[i].offset]] = 1;
      }

  for (double *f : a.force)
    state_.zero(f);
  if (history_)
  {
    const bool measure = energy || history_->measurement_is_due();
    const auto bonds   = history_->bonds();
    if (measure)
    {
      state_.zero(a.energy);
      state_.zero(bonds.dissipated);
    }
    (measure ? kernel_->relaxing_force_and_energy : kernel_->relaxing_force)(a, table, bonds, 0,
                                                                             last);
    history_->end(a, measure);
  }
  else if (energy)
  {
    state_.zero(a.energy);
    kernel_->force_and_energy(a, table, 0, last);
  }
  else
    kernel_->force(a, table, 0, last);
}

void PeridynamicForce::advance(const double kick, const double drift)
{
  kernel_->advance(state_.arrays, lattice_.owned_begin() / Lattice::block_size,
                   lattice_.owned_end() / Lattice::block_size, kick / mass_, drift);
}

int PeridynamicForce::family_size(const std::ptrdiff_t index, const std::uint8_t *bonds) const
{
  const auto bond = [&](const std::ptrdiff_t p, const std::size_t k)
  {
    return (bonds[(p / Lattice::block_size) * shifts_.size() + k] >> (p % Lattice::block_size)) & 1;
  };
  int n = 0;
  for (std::size_t k = 0; k < shifts_.size(); ++k)
    n += bond(index, k) + (index >= shifts_[k] ? bond(index - shifts_[k], k) : 0);
  return n;
}

double PeridynamicForce::count_bonds() const
{
  double ends = 0.;
  for (std::ptrdiff_t p = lattice_.owned_begin(); p < lattice_.owned_end(); ++p)
    if (lattice_.owned(p))
      ends += family_size(p, state_.arrays.bonds);
  MPI_Allreduce(MPI_IN_PLACE, &ends, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return ends / 2.;
}

double PeridynamicForce::damage(const std::ptrdiff_t index) const
{
  if (initial_family_[index] == 0 || !damaged_[index])
    return 0.;
  return 1. - double(family_size(index, state_.arrays.bonds)) / initial_family_[index];
}

bool PeridynamicForce::is_surface(const std::ptrdiff_t index) const
{
  return initial_family_[index] < 2 * shifts_.size();
}
} // namespace ricochet
