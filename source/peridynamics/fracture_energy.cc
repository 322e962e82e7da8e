// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fracture_energy.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
FractureEnergy::FractureEnergy(const PeridynamicBody &body, const bool mirrored) :
  body_(body), multiplicity_(mirrored ? 2. : 1.), sums_(body.lattice().box().n[0])
{
}

void FractureEnergy::record(const double dt)
{
  const Lattice &lattice             = body_.lattice();
  const auto &a                      = body_.state().arrays;
  const auto &law                    = *body_.material().law;
  const BondViscosity *const history = body_.history();
  const std::size_t n_branches       = history == nullptr ? 0 : history->branches().size();
  std::size_t n_bonds                = 0;
  lost_theta_.clear();
  for (std::size_t n = 0; n < body_.n_broken_entries(); ++n)
  {
    const auto &entry = body_.broken()[n];
    const auto &c     = body_.bond_constants()[entry.offset];
    const auto shift  = lattice.shift(lattice.stencil().offsets[entry.offset]);
    for (int lane = 0; lane < Lattice::block_size; ++lane)
    {
      if (!((entry.points >> lane) & 1))
        continue;
      const std::ptrdiff_t p = static_cast<std::ptrdiff_t>(entry.block) * Lattice::block_size +
                               lane,
                           q = p + shift;
      double squared = 0., squared_before = 0.;
      for (int d = 0; d < 3; ++d)
      {
        const double now    = a.position[d][q] - a.position[d][p];
        const double before = now - dt * (a.velocity[d][q] - a.velocity[d][p]);
        squared += now * now;
        squared_before += before * before;
      }
      const double extension        = std::sqrt(squared) - c.length,
                   extension_before = std::sqrt(squared_before) - c.length;
      // The bilinear form of a quadratic energy by polarisation.
      double energy = 0.5 * (law.bond_energy(c, extension) + law.bond_energy(c, extension_before) -
                             law.bond_energy(c, extension - extension_before));
      LostTheta lost{p, c.dilatation * extension, c.dilatation * extension_before, {}};
      // A branch holds k (e - e_b)^2 / 2; its back-extension stays where it was one step ago.
      for (std::size_t k = 0; k < n_branches; ++k)
      {
        const auto &branch = history->branches()[k];
        const double before =
            held_before(branch, extension_before, history->broken()[n_bonds * n_branches + k]);
        energy += branch.share * 0.5 * c.extension *
                  (before * (before + extension - extension_before) - extension * extension_before);
        lost.held_before[k] = c.dilatation * before;
      }
      ++n_bonds;
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
  }
  if (!law.has_dilatation)
    return;

  std::stable_sort(lost_theta_.begin(), lost_theta_.end(),
                   [](const auto &x, const auto &y) { return x.point < y.point; });
  for (std::size_t i = 0; i < lost_theta_.size();)
  {
    const std::ptrdiff_t p = lost_theta_[i].point;
    double now = 0., before = 0.;
    std::array<double, max_maxwell_branches> held_by_lost{};
    for (; i < lost_theta_.size() && lost_theta_[i].point == p; ++i)
    {
      now += lost_theta_[i].now;
      before += lost_theta_[i].before;
      for (std::size_t k = 0; k < n_branches; ++k)
        held_by_lost[k] += lost_theta_[i].held_before[k];
    }
    // theta without the broken bonds at this step, with them one step ago.
    const double without = a.theta[p], with = a.theta_before[p];
    auto &sum = sums_[lattice.plane_of(p)][0];
    sum += body_.point_stiffness() * ((without + now) * with - without * (with - before));
    // The branches' share of the shear part, -(5/6) mu theta^2 V, with what they hold of theta.
    for (std::size_t k = 0; k < n_branches; ++k)
    {
      const auto &branch = history->branches()[k];
      const double rest  = held_before(branch, with - before, history->of_theta(p, int(k)));
      const double all   = rest + held_by_lost[k];
      const double energy =
          all * (all + without + now - with) - rest * (rest + without - (with - before));
      const double elastic = (without + now) * with - without * (with - before);
      sum -= 5. / 6. * body_.material().shear_modulus * body_.point_volume() * branch.share *
             (energy - elastic);
    }
  }
}

FractureEnergy::Total FractureEnergy::total(const MPI_Comm communicator) const
{
  const auto sum = sums_.total(communicator);
  return {multiplicity_ * sum[0], multiplicity_ * sum[1] / 2.};
}
} // namespace ricochet
