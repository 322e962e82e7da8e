// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_viscosity.h"

#include "plane_exchange.h"
#include "ricochet/peridynamics/plane_archive.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
BondViscosity::BondViscosity(const Lattice &lattice, const FamilyConstants &family,
                             const std::vector<BondConstants> &constants,
                             const RelaxationSeries &series, const HistoryPrecision precision,
                             const double dt) :
  lattice_(lattice),
  family_(family), constants_(constants), shifts_(lattice.shifts()), dt_(dt),
  history_(lattice.size(), constants.size(), series.size(), precision),
  dissipated_(lattice.box().n[0]), in_one_step_(lattice.box().n[0])
{
  for (const auto &branch : series)
  {
    branches_.push_back(maxwell_step(branch, dt));
    halted_branches_.push_back(branches_.back());
    halted_branches_.back().decay = 1.;
    halted_branches_.back().feed  = 0.;
  }
  theta_history_.assign(series.size(), std::vector<double>(lattice.size(), 0.));
  for (auto *field : {&volumetric_, &dissipated_at_, &lost_theta_})
    field->assign(lattice.size(), 0.);
}

/// Of one step ago [m].
double BondViscosity::extension_before(const LatticeArrays &a, const std::ptrdiff_t p,
                                       const std::size_t offset) const
{
  const std::ptrdiff_t q = p + shifts_[offset];
  double squared         = 0.;
  for (int d = 0; d < 3; ++d)
  {
    const double difference =
        a.position[d][q] - a.position[d][p] - dt_ * (a.velocity[d][q] - a.velocity[d][p]);
    squared += difference * difference;
  }
  return std::sqrt(squared) - constants_[offset].length;
}

void BondViscosity::begin(const LatticeArrays &a)
{
  if (!first_step_ && !begun_)
    for_each_block_point(
        [&](const std::ptrdiff_t p)
        {
          for (std::size_t k = 0; k < branches_.size(); ++k)
            theta_history_[k][p] =
                next_history(branches_[k], a.theta_before[p], theta_history_[k][p]);
        });
  begun_ = true;
}

/// The histories of broken bonds out of theta_b of their ends.
void BondViscosity::take_out(const LatticeArrays &a, const BrokenBondLog &broken)
{
  broken_.clear();
  for (const std::ptrdiff_t p : losers_)
    lost_theta_[p] = 0.;
  losers_.clear();
  broken.for_each(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t offset)
      {
        const double dilatation = constants_[offset].dilatation;
        const double lost       = dilatation * extension_before(a, p, offset);
        for (std::size_t k = 0; k < branches_.size(); ++k)
        {
          broken_.push_back(history_.read(p, offset, k));
          for (const std::ptrdiff_t end : {p, q})
            theta_history_[k][end] -= dilatation * broken_.back();
        }
        for (const std::ptrdiff_t end : {p, q})
        {
          lost_theta_[end] += lost;
          losers_.push_back(end);
        }
      });
}

void BondViscosity::close_theta(const LatticeArrays &a, const BrokenBondLog &broken)
{
  take_out(a, broken);
  const double K = family_.bulk_modulus, mu = family_.shear_modulus;
  double at_once = K / (10. * mu) - 1. / 6.;
  for (const auto &branch : branches_)
    at_once += branch.share * branch.lag / 6.;
  for_each_block_point(
      [&](const std::ptrdiff_t p)
      {
        double s = at_once * a.theta[p];
        for (std::size_t k = 0; k < branches_.size(); ++k)
          s += branches_[k].share / 6. * theta_history_[k][p];
        volumetric_[p] = s;
      });
}

RelaxingBonds BondViscosity::bonds(const bool is_step)
{
  return {static_cast<int>(branches_.size()),
          is_step ? branches_.data() : halted_branches_.data(),
          history_.singles(),
          history_.doubles(),
          volumetric_.data(),
          dissipated_at_.data(),
          dt_};
}

void BondViscosity::end(const LatticeArrays &a, const bool measured, const bool is_step)
{
  const bool first = first_step_;
  if (is_step)
  {
    ++steps_since_measured_;
    first_step_ = begun_ = false;
  }
  if (!measured)
    return;

  // K theta^2/2 - (5/6) [mu_inf theta^2 + sum mu_k (theta - theta_b,k)^2], and the dissipation of
  // the second part as in the kernel. w theta^2 = (w theta)^2/w; without weight theta is zero.
  const double K = family_.bulk_modulus, mu = family_.shear_modulus, V = family_.volume;
  double equilibrium = 1.;
  for (const auto &branch : branches_)
    equilibrium -= branch.share;
  PlaneSums<1> now(lattice_.box().n[0]);
  lattice_.for_each_owned(
      [&](const std::ptrdiff_t p)
      {
        const double theta = a.theta[p], before = a.theta_before[p] - lost_theta_[p];
        const double volume = a.half_weight == nullptr ? V : V / (2. * a.half_weight[p] + 1e-30);
        double squares = equilibrium * theta * theta, loss = 0.;
        for (std::size_t k = 0; k < branches_.size(); ++k)
        {
          const auto &branch     = branches_[k];
          const double g         = theta_history_[k][p];
          const double held_now  = held(branch, theta, g);
          const double held_then = held_before(branch, before, g);
          squares += branch.share * held_now * held_now;
          loss +=
              branch.share * (held_now + held_then) * ((theta - before) - (held_now - held_then));
        }
        a.energy[p] += 0.5 * volume * (K * theta * theta - 5. / 3. * mu * squares);
        now[lattice_.plane_of(p)][0] += dissipated_at_[p] - 5. / 6. * mu * volume * loss;
      });
  if (!is_step)
    return;

  // Straight between two measured steps; in the first one nothing came before.
  const double n        = steps_since_measured_;
  steps_since_measured_ = 0;
  if (first)
    return;
  for (int plane = 0; plane < lattice_.box().n[0]; ++plane)
    dissipated_[plane][0] += 0.5 * ((n - 1.) * in_one_step_[plane][0] + (n + 1.) * now[plane][0]);
  in_one_step_ = now;
}

void BondViscosity::take_over(const LatticeArrays &a, const std::vector<std::uint8_t> &chosen,
                              const std::function<Eigen::Matrix3d(std::ptrdiff_t, int)> &history)
{
  begin(a);
  const std::size_t n = constants_.size();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (int lane = 0; lane < Lattice::block_size && chosen[i] != 0; ++lane)
      if ((chosen[i] >> lane) & 1)
      {
        const std::ptrdiff_t p = static_cast<std::ptrdiff_t>(i / n) * Lattice::block_size + lane,
                             q = p + shifts_[i % n];
        for (int k = 0; k < n_branches(); ++k)
          history_.write(p, i % n, k, along(i % n, 0.5 * (history(p, k) + history(q, k))));
      }
  sum_theta(a);
}

double BondViscosity::along(const std::size_t offset, const Eigen::Matrix3d &G) const
{
  const auto &o    = lattice_.stencil().offsets[offset];
  const Vector3 xi = lattice_.stencil().spacing * Vector3(o.x, o.y, o.z);
  return xi.dot(G * xi) / o.length;
}

void BondViscosity::sum_theta(const LatticeArrays &a)
{
  for (auto &field : theta_history_)
    std::fill(field.begin(), field.end(), 0.);
  const std::size_t n = constants_.size();
  for (const auto &range : lattice_.existing_ranges())
    for (std::ptrdiff_t p = range.first * Lattice::block_size;
         p < std::min<std::ptrdiff_t>(range.last * Lattice::block_size, lattice_.owned_end()); ++p)
      for (std::size_t offset = 0; offset < n; ++offset)
        if ((a.bonds[(p / Lattice::block_size) * n + offset] >> (p % Lattice::block_size)) & 1)
          for (int k = 0; k < n_branches(); ++k)
          {
            const double part = constants_[offset].dilatation * history_.read(p, offset, k);
            theta_history_[k][p] += part;
            theta_history_[k][p + shifts_[offset]] += part;
          }
  if (a.half_weight != nullptr)
    for_each_block_point(
        [&](const std::ptrdiff_t p)
        {
          for (auto &field : theta_history_)
            field[p] *= 2. * a.half_weight[p];
        });
}

void BondViscosity::find_losers()
{
  losers_.clear();
  for (std::size_t p = 0; p < lost_theta_.size(); ++p)
    if (lost_theta_[p] != 0.)
      losers_.push_back(static_cast<std::ptrdiff_t>(p));
}

void BondViscosity::redistribute(const PlaneExchange &planes, const Lattice &share,
                                 const MPI_Comm communicator)
{
  history_.redistribute(planes);
  for (auto &field : theta_history_)
    planes.move(field);
  planes.move(lost_theta_);
  find_losers();
  for (auto *field : {&volumetric_, &dissipated_at_})
    field->assign(share.size(), 0.);
  for (auto *sums : {&dissipated_, &in_one_step_})
    sums->move_home(communicator, share.first_plane(), share.first_plane() + share.n_planes());
}

void BondViscosity::exchange_state(PlaneArchive &planes)
{
  history_.exchange_state(planes, "bond histories");
  for (std::size_t k = 0; k < theta_history_.size(); ++k)
    planes.field("dilatation history " + std::to_string(k), theta_history_[k].data());
  planes.field("lost dilatation", lost_theta_.data());
  planes.sums("viscous dissipation", dissipated_);
  planes.sums("viscous dissipation in one step", in_one_step_);
  planes.archive().common("is first step", first_step_);
  planes.archive().common("steps since measured", steps_since_measured_);
  if (planes.archive().is_restoring())
  {
    begun_ = false; // whatever building the body has begun
    find_losers();
  }
}

double BondViscosity::bytes_per_point() const
{
  const double per_bond = static_cast<double>(history_.bytes_per_bond_and_branch());
  const auto n_branches = static_cast<double>(branches_.size()),
             n_bonds    = static_cast<double>(constants_.size());
  return n_branches * (n_bonds * per_bond + sizeof(double)) + 3 * sizeof(double);
}
} // namespace ricochet
