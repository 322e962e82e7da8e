// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_viscosity.h"

#include "plane_exchange.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
BondViscosity::BondViscosity(const Lattice &lattice, const FamilyConstants &family,
                             const std::vector<BondConstants> &constants,
                             const RelaxationSeries &series, const HistoryPrecision precision,
                             const double dt) :
  lattice_(lattice),
  family_(family), constants_(constants), dt_(dt), dissipated_(lattice.box().n[0]),
  in_one_step_(lattice.box().n[0])
{
  for (const auto &offset : lattice.stencil().offsets)
    shifts_.push_back(lattice.shift(offset));
  for (const auto &branch : series)
  {
    branches_.push_back(maxwell_step(branch, dt));
    halted_branches_.push_back(branches_.back());
    halted_branches_.back().decay = 1.;
    halted_branches_.back().feed  = 0.;
  }
  const std::size_t n_bonds = lattice.size() * constants.size() * series.size();
  if (precision == HistoryPrecision::single_precision)
    single_history_.assign(n_bonds, 0.f);
  else
    double_history_.assign(n_bonds, 0.);
  theta_history_.assign(series.size(), std::vector<double>(lattice.size(), 0.));
  for (auto *field : {&volumetric_, &dissipated_at_, &lost_theta_})
    field->assign(lattice.size(), 0.);
}

std::size_t BondViscosity::entry(const std::ptrdiff_t point, const std::size_t offset,
                                 const int branch) const
{
  const std::size_t block = point / Lattice::block_size, lane = point % Lattice::block_size;
  return ((block * constants_.size() + offset) * branches_.size() + branch) * Lattice::block_size +
         lane;
}

double BondViscosity::read(const std::size_t entry) const
{
  return single_history_.empty() ? double_history_[entry] : single_history_[entry];
}

void BondViscosity::write(const std::size_t entry, const double value)
{
  if (single_history_.empty())
    double_history_[entry] = value;
  else
    single_history_[entry] = static_cast<float>(value);
}

double BondViscosity::extension(const LatticeArrays &a, const std::ptrdiff_t p,
                                const std::size_t offset, const double dt) const
{
  const std::ptrdiff_t q = p + shifts_[offset];
  double squared         = 0.;
  for (int d = 0; d < 3; ++d)
  {
    const double difference =
        a.position[d][q] - a.position[d][p] - dt * (a.velocity[d][q] - a.velocity[d][p]);
    squared += difference * difference;
  }
  return std::sqrt(squared) - constants_[offset].length;
}

double BondViscosity::back_extension(const std::ptrdiff_t point, const std::size_t offset,
                                     const int branch, const double e) const
{
  return read(entry(point, offset, branch)) + branches_[branch].lag * e;
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

void BondViscosity::close_theta(const LatticeArrays &a, const BrokenBonds *broken,
                                const std::size_t n_broken)
{
  broken_.clear();
  for (const std::ptrdiff_t p : losers_)
    lost_theta_[p] = 0.;
  losers_.clear();
  for (std::size_t i = 0; i < n_broken; ++i)
    for (int lane = 0; lane < Lattice::block_size; ++lane)
    {
      if (!((broken[i].points >> lane) & 1))
        continue;
      const std::size_t offset = broken[i].offset;
      const std::ptrdiff_t p = static_cast<std::ptrdiff_t>(broken[i].block) * Lattice::block_size +
                               lane,
                           q  = p + shifts_[offset];
      const double dilatation = constants_[offset].dilatation;
      const double lost       = dilatation * extension(a, p, offset, dt_);
      for (std::size_t k = 0; k < branches_.size(); ++k)
      {
        broken_.push_back(read(entry(p, offset, static_cast<int>(k))));
        for (const std::ptrdiff_t end : {p, q})
          theta_history_[k][end] -= dilatation * broken_.back();
      }
      for (const std::ptrdiff_t end : {p, q})
      {
        lost_theta_[end] += lost;
        losers_.push_back(end);
      }
    }

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
          single_history_.empty() ? nullptr : single_history_.data(),
          double_history_.empty() ? nullptr : double_history_.data(),
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

void BondViscosity::start_from(
    const LatticeArrays &a, const std::function<Eigen::Matrix3d(const Vector3 &, int)> &back_strain)
{
  // E_b at an image is that of its original, seen in the mirror.
  const double plane   = lattice_.box().corner.y();
  const bool mirrored  = lattice_.box().mirror_y;
  const auto strain_at = [&](Vector3 X, const int branch) -> Eigen::Matrix3d
  {
    const bool image = mirrored && X.y() < plane;
    if (image)
      X.y() = 2. * plane - X.y();
    Eigen::Matrix3d E = back_strain(X, branch);
    if (image)
      for (const int d : {0, 2})
        E(1, d) = E(d, 1) = -E(1, d);
    return E;
  };
  const std::size_t n = constants_.size();
  for (std::ptrdiff_t p = 0; p < lattice_.owned_end(); ++p)
    for (std::size_t offset = 0; offset < n; ++offset)
      if ((a.bonds[(p / Lattice::block_size) * n + offset] >> (p % Lattice::block_size)) & 1)
      {
        const Vector3 X = lattice_.reference_position(lattice_.coordinates(p)),
                      Y = lattice_.reference_position(lattice_.coordinates(p + shifts_[offset]));
        const double e  = extension(a, p, offset, 0.);
        for (int k = 0; k < n_branches(); ++k)
          write(entry(p, offset, k),
                along(offset, 0.5 * (strain_at(X, k) + strain_at(Y, k))) - branches_[k].lag * e);
      }
  sum_theta(a);
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
          write(entry(p, i % n, k), along(i % n, 0.5 * (history(p, k) + history(q, k))));
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
            const double part = constants_[offset].dilatation * read(entry(p, offset, k));
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

void BondViscosity::redistribute(const PlaneExchange &planes, const std::ptrdiff_t size)
{
  const double n_per_point = static_cast<double>(constants_.size() * branches_.size());
  const auto move          = [&](auto &field, const double per_point)
  {
    auto moved = field;
    moved.assign(static_cast<std::size_t>(static_cast<double>(size) * per_point), 0);
    planes.move(field.data(), moved.data(), per_point);
    field = std::move(moved);
  };
  if (!single_history_.empty())
    move(single_history_, n_per_point);
  if (!double_history_.empty())
    move(double_history_, n_per_point);
  for (auto &field : theta_history_)
    move(field, 1.);
  move(lost_theta_, 1.);
  losers_.clear();
  for (std::ptrdiff_t p = 0; p < size; ++p)
    if (lost_theta_[p] != 0.)
      losers_.push_back(p);
  for (auto *field : {&volumetric_, &dissipated_at_})
    field->assign(size, 0.);
}

double BondViscosity::bytes_per_point() const
{
  const double per_bond = single_history_.empty() ? sizeof(double) : sizeof(float);
  const auto n_branches = static_cast<double>(branches_.size()),
             n_bonds    = static_cast<double>(constants_.size());
  return n_branches * (n_bonds * per_bond + sizeof(double)) + 3 * sizeof(double);
}
} // namespace ricochet
