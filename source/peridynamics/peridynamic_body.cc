// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/peridynamic_body.h"

#include "fracture_energy.h"
#include "plane_exchange.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/peridynamics/plane_sums.h"

#include <Eigen/Geometry>

#include <algorithm>
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

PeridynamicBody::PeridynamicBody(const MPI_Comm communicator, const int number,
                                 const Lattice::Box &box, const Stencil &stencil,
                                 const PeridynamicMaterial &material, const Lattice::Mask &mask,
                                 const char *instruction_set, const Zone *zone) :
  communicator_(communicator),
  number_(number), lattice_(box, stencil, rank_of(communicator), size_of(communicator), mask, zone),
  state_(lattice_), material_(material), halo_(communicator, lattice_, number),
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
  broken_.resize(kernel_->registers_per_block * initial_bonds_.size());
  set_families();
  find_bond_ranges();
  fracture_ = std::make_unique<FractureEnergy>(*this, /*mirrored=*/false);
}

PeridynamicBody::~PeridynamicBody() = default;

void PeridynamicBody::set_families()
{
  initial_family_.assign(lattice_.size(), 0);
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      { initial_family_[p] = static_cast<std::uint16_t>(family_size(p, initial_bonds_.data())); });
}

void PeridynamicBody::find_bond_ranges()
{
  const std::size_t n    = shifts_.size();
  const std::size_t last = lattice_.owned_end() / Lattice::block_size;
  const double *half     = state_.arrays.half_weight;
  const auto has_weight  = [half](const std::ptrdiff_t p)
  { return half != nullptr && half[p] != 0.5; };
  // Also points without bonds of their own in the forward half count: their dilatation has energy.
  std::vector<std::uint8_t> whole(last, 0), weighted(last, 0);
  for (std::size_t block = 0; block < last; ++block)
  {
    const std::ptrdiff_t first = block * Lattice::block_size;
    for (std::ptrdiff_t p = first; p < first + Lattice::block_size; ++p)
      if (lattice_.exists(p) && lattice_.kind(p) != PointKind::contact)
        (has_weight(p) ? weighted : whole)[block] = 1;
    for (std::size_t k = 0; k < n && half != nullptr && !weighted[block]; ++k)
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((initial_bonds_[block * n + k] >> lane) & 1 && has_weight(first + lane + shifts_[k]))
          weighted[block] = 1;
    whole[block] &= !weighted[block];
  }
  // Rows are a few blocks long. To call one kernel for the start of a row and another for its end
  // costs more than weights that are 1.
  constexpr std::int64_t least_run = 16;
  for (const auto &run : ranges_of_blocks(whole))
    if (half != nullptr && run.last - run.first < least_run)
      for (std::int64_t block = run.first; block < run.last; ++block)
        std::swap(whole[block], weighted[block]);
  whole_ranges_    = ranges_of_blocks(whole);
  weighted_ranges_ = ranges_of_blocks(weighted);
  for (std::size_t block = 0; block < last; ++block)
    whole[block] |= weighted[block];
  bond_ranges_ = ranges_of_blocks(whole);
}

void PeridynamicBody::scale_energy(const std::vector<double> &factor)
{
  for (const auto &range : lattice_.existing_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
      if (lattice_.exists(p))
        state_.arrays.half_weight[p] *= factor[p];
  find_bond_ranges();
}

void PeridynamicBody::follow_zone(const int first, const int last)
{
  lattice_.follow_zone(first, last);
  state_.follow_zone(lattice_, first, last);
  // Bonds of the planes below reach up into the changed ones.
  const std::ptrdiff_t reach = lattice_.stencil().reach;
  const auto block_of        = [&](const std::ptrdiff_t plane)
  {
    return std::clamp<std::ptrdiff_t>((plane - lattice_.first_plane() + reach) *
                                          lattice_.plane_stride(),
                                      0, lattice_.owned_end()) /
           Lattice::block_size;
  };
  const std::int64_t from = block_of(first - reach), to = block_of(last);
  const std::size_t n = shifts_.size();
  auto bonds          = initial_bonds_;
  lattice_.set_intact_bonds(from, to, bonds.data());
  new_bonds_.assign(history_ ? bonds.size() : 0, 0);
  for (std::size_t i = from * n; i < to * n; ++i)
  {
    state_.arrays.bonds[i] |= bonds[i] & ~initial_bonds_[i];
    if (history_)
      new_bonds_[i] = bonds[i] & ~initial_bonds_[i];
  }
  initial_bonds_ = std::move(bonds);
  set_families();
  find_bond_ranges();
}

void PeridynamicBody::redistribute(const std::vector<int> &plane_starts)
{
  Lattice lattice(lattice_, plane_starts, rank_of(communicator_));
  LatticeState state(lattice);
  const PlaneExchange planes(communicator_, lattice_, lattice);
  const auto &from = state_.arrays;
  auto &to         = state.arrays;
  for (int d = 0; d < 3; ++d)
  {
    planes.move(from.position[d], to.position[d]);
    planes.move(from.velocity[d], to.velocity[d]);
  }
  planes.move(from.theta_before, to.theta_before);

  // A ghost's bonds with other ghosts do not exist here.
  initial_bonds_.assign(to.bonds, to.bonds + lattice.size() / Lattice::block_size * shifts_.size());
  planes.move(from.bonds, to.bonds, static_cast<double>(shifts_.size()) / Lattice::block_size);
  for (std::size_t i = 0; i < initial_bonds_.size(); ++i)
    to.bonds[i] &= initial_bonds_[i];
  std::vector<char> damaged(lattice.size(), 0);
  planes.move(damaged_.data(), damaged.data());
  damaged_ = std::move(damaged);
  if (history_)
    history_->redistribute(planes, lattice.size());

  lattice_ = std::move(lattice);
  state_   = std::move(state);
  halo_    = Halo(communicator_, lattice_, number_);
  broken_.resize(kernel_->registers_per_block * initial_bonds_.size());
  n_broken_ = 0;
  set_families();
  find_bond_ranges();
}

void PeridynamicBody::continue_history(TensorFields &histories)
{
  for (auto &tensor : histories)
    for (int i = 0; i < 6; ++i)
    {
      double *const field = tensor[i].data();
      halo_.exchange({field});
      // 23 and 12 change their sign in the mirror.
      const double sign = i == 3 || i == 5 ? -1. : 1.;
      lattice_.for_each_image([&](const std::ptrdiff_t image, const std::ptrdiff_t original)
                              { field[image] = sign * field[original]; });
    }
  history_->take_over(state_.arrays, new_bonds_,
                      [&](const std::ptrdiff_t p, const int k)
                      {
                        const auto &t = histories[k];
                        Eigen::Matrix3d G;
                        G << t[0][p], t[5][p], t[4][p], t[5][p], t[1][p], t[3][p], t[4][p], t[3][p],
                            t[2][p];
                        return G;
                      });
  new_bonds_.clear();
}

std::vector<std::ptrdiff_t>
PeridynamicBody::points_stretched(const double stretch,
                                  const std::vector<Lattice::BlockRange> &blocks)
{
  // The kernel breaks what is stretched in a copy; its log says what.
  LatticeArrays copy = state_.arrays;
  auto constants     = constants_;
  for (auto &c : constants)
    c.critical = stretch * c.length;
  BondTable table = table_;
  table.constants = constants.data();
  watched_bonds_.resize(initial_bonds_.size());
  watched_theta_.resize(lattice_.size());
  copy.bonds = watched_bonds_.data();
  copy.theta = watched_theta_.data();

  std::vector<std::ptrdiff_t> points;
  std::vector<BrokenBonds> log;
  for (const auto &range : blocks)
  {
    const std::size_t n = shifts_.size() * (range.last - range.first);
    std::copy_n(state_.arrays.bonds + range.first * shifts_.size(), n,
                watched_bonds_.begin() + range.first * shifts_.size());
    log.resize(kernel_->registers_per_block * n);
    const auto n_log = kernel_->stretch(copy, table, range.first, range.last, log.data());
    for (std::int64_t i = 0; i < n_log; ++i)
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((log[i].points >> lane) & 1)
          points.push_back(static_cast<std::ptrdiff_t>(log[i].block) * Lattice::block_size + lane);
  }
  return points;
}

void PeridynamicBody::start_relaxation(const double dt)
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
  history_ = std::make_unique<BondViscosity>(
      lattice_,
      family_constants(lattice_.stencil(), material_.bulk_modulus, material_.shear_modulus),
      unbreakable_constants_, material_.relaxation, material_.history_precision, dt);
}

void PeridynamicBody::update_ghosts()
{
  auto &a = state_.arrays;
  halo_.exchange(
      {a.position[0], a.position[1], a.position[2], a.velocity[0], a.velocity[1], a.velocity[2]});
  state_.mirror_motion(lattice_);
}

void PeridynamicBody::break_bonds()
{
  compute_dilatation(table_);
  mark_damaged();
  has_dilatation_ = true;
}

void PeridynamicBody::book_fracture(const double dt)
{
  fracture_->record(dt);
}

/// Bonds that `table` says to break do so, and the others add up to theta.
void PeridynamicBody::compute_dilatation(const BondTable &table)
{
  // Bonds between a ghost and an owned point are visited on both ranks: the sums of owned points
  // are then complete, and made in the same order as on one rank, without sending anything home.
  auto &a  = state_.arrays;
  in_step_ = true;
  if (history_)
    history_->begin(a);
  state_.zero(lattice_, a.theta);
  n_broken_ = 0;
  for (const auto &range : bond_ranges_)
    n_broken_ += static_cast<std::size_t>(
        kernel_->stretch(a, table, range.first, range.last, broken_.data() + n_broken_));
  if (!material_.law->has_dilatation)
    return;
  weigh_dilatation();
  if (history_)
    history_->close_theta(a, broken_.data(), n_broken_);
  double *const shared = history_ ? history_->volumetric() : a.theta;
  halo_.exchange({shared});
  state_.mirror(lattice_, shared);
}

void PeridynamicBody::mark_damaged()
{
  for_each_newly_broken_bond([&](const std::ptrdiff_t p, const std::ptrdiff_t q, std::size_t)
                             { damaged_[p] = damaged_[q] = 1; });
}

void PeridynamicBody::compute_internal_forces(const ForceRequest &request)
{
  if (!std::exchange(has_dilatation_, false))
    compute_dilatation(unbreakable_table_);
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
  const auto add_with = [&](const auto kernel, const std::vector<Lattice::BlockRange> &ranges)
  {
    for (const auto &range : ranges)
      kernel(a, table_, range.first, range.last);
  };
  add_with(energy ? kernel_->force_and_energy : kernel_->force, whole_ranges_);
  add_with(energy ? kernel_->weighted_force_and_energy : kernel_->weighted_force, weighted_ranges_);
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
  const auto add_with = [&](const auto kernel, const std::vector<Lattice::BlockRange> &ranges)
  {
    for (const auto &range : ranges)
      kernel(a, table_, bonds, range.first, range.last);
  };
  const auto &k = *kernel_;
  add_with(measure ? k.relaxing_force_and_energy : k.relaxing_force, whole_ranges_);
  add_with(measure ? k.weighted_relaxing_force_and_energy : k.weighted_relaxing_force,
           weighted_ranges_);
  history_->end(a, measure, request.is_step);
}

/// From theta to w theta.
void PeridynamicBody::weigh_dilatation()
{
  auto &a = state_.arrays;
  if (a.half_weight == nullptr)
    return;
  for (const auto &range : lattice_.owned_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size; p < range.last * Lattice::block_size;
         ++p)
      a.theta[p] *= 2. * a.half_weight[p];
}

void PeridynamicBody::advance(const double kick, const double drift)
{
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
  const auto &a = state_.arrays;
  PlaneSums<2> sums(lattice_.box().n[0]);
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        auto &sum = sums[lattice_.plane_of(p)];
        if (lattice_.free(p))
        {
          const Vector3 v(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]),
              f(a.force[0][p], a.force[1][p], a.force[2][p]);
          sum[0] += 0.5 * mass_ * v.dot(v + dt / mass_ * f);
        }
        sum[1] += a.energy[p];
      });
  const auto sum = sums.total(communicator_);
  Energies energies;
  energies.kinetic  = sum[0];
  energies.strain   = sum[1];
  energies.viscous  = history_ ? history_->dissipated(communicator_) : 0.;
  energies.fracture = fracture_->total(communicator_).energy;
  return energies;
}

Momenta PeridynamicBody::momenta() const
{
  const auto &a = state_.arrays;
  PlaneSums<6> sums(lattice_.box().n[0]);
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        if (!lattice_.free(p))
          return;
        const Vector3 linear =
            mass_ * Vector3(a.velocity[0][p], a.velocity[1][p], a.velocity[2][p]);
        const Vector3 angular =
            Vector3(a.position[0][p], a.position[1][p], a.position[2][p]).cross(linear);
        for (int d = 0; d < 3; ++d)
        {
          sums[lattice_.plane_of(p)][d] += linear[d];
          sums[lattice_.plane_of(p)][3 + d] += angular[d];
        }
      });
  const auto sum = sums.total(communicator_);
  return {{sum[0], sum[1], sum[2]}, {sum[3], sum[4], sum[5]}};
}

void PeridynamicBody::rest()
{
  auto &a = state_.arrays;
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const Vector3 x = lattice_.reference_position(lattice_.coordinates(p));
        for (int d = 0; d < 3; ++d)
        {
          a.position[d][p] = x[d];
          a.velocity[d][p] = a.force[d][p] = 0.;
        }
      });
  update_ghosts();
  state_.zero(lattice_, a.theta);
  state_.zero(lattice_, a.theta_before);
}

std::string PeridynamicBody::first_not_finite() const
{
  const auto &a = state_.arrays;
  const std::array<std::pair<const char *, double *const *>, 3> fields{
      {{"position", a.position}, {"velocity", a.velocity}, {"force", a.force}}};
  // A sum that is finite has finite terms, and needs no branches.
  double sum = 0.;
  for (const auto &range : lattice_.owned_ranges())
    for (const auto &[name, field] : fields)
      for (int d = 0; d < 3; ++d)
        for (std::ptrdiff_t p = range.first * Lattice::block_size;
             p < range.last * Lattice::block_size; ++p)
          sum += 0. * field[d][p];
  std::string found;
  if (sum == 0.)
    return found;
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        for (const auto &[name, field] : fields)
          if (found.empty() && !Vector3(field[0][p], field[1][p], field[2][p]).allFinite())
          {
            const auto c = lattice_.coordinates(p);
            std::ostringstream text;
            text << "The " << name << " of point (" << c[0] << ", " << c[1] << ", " << c[2] << ")";
            found = text.str();
          }
      });
  return found;
}

int PeridynamicBody::family_size(const std::ptrdiff_t index, const std::uint8_t *bonds) const
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

double PeridynamicBody::count_bonds() const
{
  double ends = 0.;
  lattice_.for_each_owned([&](const std::ptrdiff_t p)
                          { ends += family_size(p, state_.arrays.bonds); });
  MPI_Allreduce(MPI_IN_PLACE, &ends, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return ends / 2.;
}

double PeridynamicBody::n_broken_bonds() const
{
  return multiplicity() * fracture_->total(communicator_).n_bonds;
}

double PeridynamicBody::count_sound_bonds() const
{
  double ends = 0.;
  lattice_.for_each_owned([&](const std::ptrdiff_t p) { ends += initial_family_[p]; });
  MPI_Allreduce(MPI_IN_PLACE, &ends, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  return ends / 2.;
}

double PeridynamicBody::damage(const std::ptrdiff_t index) const
{
  if (initial_family_[index] == 0 || !damaged_[index])
    return 0.;
  return 1. - double(family_size(index, state_.arrays.bonds)) / initial_family_[index];
}
} // namespace ricochet
