// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fracture_energy.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
struct Extension
{
  double now, before; // at this step and one step ago [m]
};

Extension extension(const LatticeArrays &a, const std::ptrdiff_t p, const std::ptrdiff_t q,
                    const double length, const double dt)
{
  double squared = 0., squared_before = 0.;
  for (int d = 0; d < 3; ++d)
  {
    const double now    = a.position[d][q] - a.position[d][p];
    const double before = now - dt * (a.velocity[d][q] - a.velocity[d][p]);
    squared += now * now;
    squared_before += before * before;
  }
  return {std::sqrt(squared) - length, std::sqrt(squared_before) - length};
}
} // namespace

FractureEnergy::FractureEnergy(const PeridynamicBody &body) :
  body_(body), sums_(body.lattice().box().n[0])
{
}

void FractureEnergy::LostTheta::operator+=(const LostTheta &other)
{
  now += other.now;
  before += other.before;
  for (std::size_t k = 0; k < held_before.size(); ++k)
    held_before[k] += other.held_before[k];
}

void FractureEnergy::record(const double dt)
{
  lost_theta_.clear();
  std::size_t n_bonds = 0;
  body_.bond_damage().log().for_each(
      [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t k)
      { record_bond(p, q, k, n_bonds++, dt); });
  if (!body_.material().law->has_dilatation)
    return;

  // The energy of a point is quadratic in theta: all that it lost at once.
  std::stable_sort(lost_theta_.begin(), lost_theta_.end(),
                   [](const auto &x, const auto &y) { return x.point < y.point; });
  for (auto next = lost_theta_.begin(); next != lost_theta_.end();)
  {
    LostTheta lost{next->point, 0., 0., {}};
    for (; next != lost_theta_.end() && next->point == lost.point; ++next)
      lost += *next;
    record_theta(lost);
  }
}

void FractureEnergy::record_bond(const std::ptrdiff_t p, const std::ptrdiff_t q,
                                 const std::size_t k, const std::size_t number, const double dt)
{
  const auto &law      = *body_.material().law;
  const auto &c        = body_.bond_constants()[k];
  const auto e         = extension(body_.state().arrays, p, q, c.length, dt);
  const double plastic = body_.flow() == nullptr ? 0. : body_.flow()->plastic_extension(p, k);
  // The bilinear form of a quadratic energy by polarisation.
  double energy =
      0.5 * (law.bond_energy(c, e.now - plastic) + law.bond_energy(c, e.before - plastic) -
             law.bond_energy(c, e.now - e.before));
  LostTheta lost{p, c.dilatation * e.now, c.dilatation * e.before, {}};
  // A branch holds k (e - e_b)^2 / 2; its back-extension stays where it was one step ago.
  const BondViscosity *const history = body_.history();
  const std::size_t n_branches       = history == nullptr ? 0 : history->branches().size();
  for (std::size_t b = 0; b < n_branches; ++b)
  {
    const auto &branch  = history->branches()[b];
    const double before = held_before(branch, e.before, history->broken()[number * n_branches + b]);
    energy += branch.share * 0.5 * c.extension *
              (before * (before + e.now - e.before) - e.now * e.before);
    lost.held_before[b] = c.dilatation * before;
  }
  const Lattice &lattice = body_.lattice();
  for (const std::ptrdiff_t end : {p, q})
    if (lattice.owned(end))
    {
      auto &sum = sums_[lattice.plane_of(end)];
      sum[0] += 0.5 * energy;
      sum[1] += 1.;
      lost.point = end;
      lost_theta_.push_back(lost);
    }
}

void FractureEnergy::record_theta(const LostTheta &lost)
{
  // theta without the broken bonds at this step, with them one step ago.
  const auto &a        = body_.state().arrays;
  const double without = a.theta[lost.point], with = a.theta_before[lost.point];
  const double elastic = (without + lost.now) * with - without * (with - lost.before);
  auto &sum            = sums_[body_.lattice().plane_of(lost.point)][0];
  sum += body_.point_stiffness() * elastic;
  // The branches' share of the shear part, -(5/6) mu theta^2 V, with what they hold of theta.
  const BondViscosity *const history = body_.history();
  const std::size_t n_branches       = history == nullptr ? 0 : history->branches().size();
  for (std::size_t b = 0; b < n_branches; ++b)
  {
    const auto &branch = history->branches()[b];
    const double rest =
        held_before(branch, with - lost.before, history->of_theta(lost.point, static_cast<int>(b)));
    const double all = rest + lost.held_before[b];
    const double energy =
        all * (all + without + lost.now - with) - rest * (rest + without - (with - lost.before));
    sum -= 5. / 6. * body_.material().shear_modulus * body_.point_volume() * branch.share *
           (energy - elastic);
  }
}

FractureEnergy::Total FractureEnergy::total(const MPI_Comm communicator) const
{
  const auto sum = sums_.total(communicator);
  return {sum[0], sum[1] / 2.};
}

void FractureEnergy::redistribute(const MPI_Comm communicator)
{
  const Lattice &lattice = body_.lattice();
  sums_.move_home(communicator, lattice.first_plane(), lattice.first_plane() + lattice.n_planes());
}
} // namespace ricochet
