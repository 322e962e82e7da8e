// SPDX-License-Identifier: LGPL-2.1-or-later
// The force of a linear peridynamic solid whose shear stiffness relaxes, and the history of its
// bonds. As kernels/lattice_kernel_loops.h, to be included behind a struct Simd.
//
// With one-dimensional Maxwell branches for e and for theta (peridynamics/bond_viscosity.h says why
// that is all) the tension of the bond between i and j is
//   t = V^2 omega (30 mu/m) [ e - sum_k lambda_k e_b,k + |xi| (s_i + s_j) ],
//   s = (K/(10 mu) - 1/6) theta + 1/6 sum_k lambda_k theta_b,k.
// Weighted: where points have a weight w, e counts with the mean of the ends' and s, like theta,
// stands for w s.
#pragma once

#include "lattice_lanes.h"
#include "ricochet/kernels/lattice_kernel.h"

namespace ricochet
{
namespace
{
/// T: of the history. n_fixed: number of branches, or 0 for any number.
template <class T, int n_fixed, bool with_energy, bool weighted>
void relaxing_force(const LatticeArrays &a, const BondTable &table, const RelaxingBonds &bonds,
                    T *const all_history, const int64_t first, const int64_t last)
{
  const double *const x = a.position[0], *const y = a.position[1], *const z = a.position[2];
  const double *const u = a.velocity[0], *const v = a.velocity[1], *const w = a.velocity[2];
  double *const fx = a.force[0], *const fy = a.force[1], *const fz = a.force[2];
  const int n_branches = n_fixed > 0 ? n_fixed : bonds.n_branches;
  const V minus_dt     = Simd::set(-bonds.dt);
  // e - sum lambda_k e_b,k = at_once e - sum lambda_k g_k
  double at_once = 1., equilibrium = 1.;
  for (int b = 0; b < n_branches; ++b)
  {
    at_once -= bonds.branches[b].share * bonds.branches[b].lag;
    equilibrium -= bonds.branches[b].share;
  }
  for (int64_t block = first; block < last; ++block)
  {
    const uint8_t *const intact  = a.bonds + block * table.n;
    const uint8_t *const cracked = a.cracked != nullptr ? a.cracked + block * table.n : nullptr;
    for (int lane = 0; lane < block_size; lane += lanes)
    {
      T *const block_history = all_history + block * table.n * n_branches * block_size + lane;
      const int64_t p        = block * block_size + lane;
      const V px = Simd::load(x + p), py = Simd::load(y + p), pz = Simd::load(z + p);
      const V volumetric = Simd::load(bonds.volumetric + p);
      V pu = Simd::zero(), pv = Simd::zero(), pw = Simd::zero();
      if constexpr (with_energy)
      {
        pu = Simd::load(u + p);
        pv = Simd::load(v + p);
        pw = Simd::load(w + p);
      }
      V sx = Simd::zero(), sy = Simd::zero(), sz = Simd::zero();
      V energy = Simd::zero(), dissipated = Simd::zero(), own_half = Simd::zero();
      if constexpr (weighted)
        own_half = Simd::load(a.half_weight + p);
      for (int k = 0; k < table.n; ++k)
      {
        const unsigned int bits   = lane_bits(intact[k], lane);
        const unsigned int cracks = cracked != nullptr ? lane_bits(cracked[k], lane) : 0;
        if ((bits | cracks) == 0)
          continue;
        const int64_t q        = p + table.shift[k];
        const BondConstants &c = table.constants[k];
        const M alive          = Simd::mask(bits);
        const V dx = Simd::load(x + q) - px, dy = Simd::load(y + q) - py,
                dz      = Simd::load(z + q) - pz;
        const V r2      = Simd::fma(dx, dx, Simd::fma(dy, dy, dz * dz));
        const V inverse = Simd::inverse_sqrt(r2);
        const V length  = Simd::set(c.length);
        const V e       = Simd::fma(r2, inverse, -length);

        V e_before = Simd::zero();
        if constexpr (with_energy)
        {
          const V bx      = Simd::fma(minus_dt, Simd::load(u + q) - pu, dx),
                  by      = Simd::fma(minus_dt, Simd::load(v + q) - pv, dy),
                  bz      = Simd::fma(minus_dt, Simd::load(w + q) - pw, dz);
          const V before2 = Simd::fma(bx, bx, Simd::fma(by, by, bz * bz));
          e_before        = Simd::fma(before2, Simd::inverse_sqrt(before2), -length);
        }

        V strain  = Simd::set(at_once) * e; // that the bond feels
        V squares = Simd::set(equilibrium) * e * e, loss = Simd::zero();
        T *const history = block_history + k * n_branches * block_size;
        for (int b = 0; b < n_branches; ++b)
        {
          const MaxwellStep &branch = bonds.branches[b];
          T *const entry            = history + b * block_size;
          const V g                 = Simd::load(entry);
          const V share             = Simd::set(branch.share);
          strain                    = Simd::fnma(share, g, strain);
          Simd::store(entry, Simd::keep(alive, Simd::fma(Simd::set(branch.decay), g,
                                                         Simd::set(branch.feed) * e)));
          if constexpr (with_energy)
          {
            // held() and held_before() of materials/relaxation.h; what the back-extension moved
            // meanwhile is the work that the dashpot took.
            const V now = Simd::fma(Simd::set(1. - branch.lag), e, -g);
            const V before =
                Simd::fma(Simd::set(1. - branch.lag), e_before, -g) * Simd::set(1. / branch.decay);
            const V moved = (e - e_before) - (now - before);
            squares       = Simd::fma(share * now, now, squares);
            loss          = Simd::fma(share * (now + before), moved, loss);
          }
        }

        V stiffness  = Simd::set(c.extension);
        const V both = volumetric + Simd::load(bonds.volumetric + q);
        V tension;
        if constexpr (weighted)
        {
          tension   = stiffness * (length * both);
          stiffness = stiffness * (own_half + Simd::load(a.half_weight + q));
          tension   = Simd::fma(stiffness, strain, tension);
        }
        else
          tension = stiffness * Simd::fma(length, both, strain);
        V t    = Simd::keep(alive, tension * inverse);
        V push = Simd::zero(); // as in the loops without relaxation: a crack has no memory
        if (cracks != 0)
        {
          push = stiffness_of_closed(cracks, e, Simd::set(table.cracked_share) * stiffness);
          t    = Simd::fma(push * e, inverse, t);
        }
        sx = Simd::fma(t, dx, sx);
        sy = Simd::fma(t, dy, sy);
        sz = Simd::fma(t, dz, sz);
        Simd::store(fx + q, Simd::fnma(t, dx, Simd::load(fx + q)));
        Simd::store(fy + q, Simd::fnma(t, dy, Simd::load(fy + q)));
        Simd::store(fz + q, Simd::fnma(t, dz, Simd::load(fz + q)));
        if constexpr (with_energy)
        {
          // Half a bond to either end.
          const V quarter = Simd::set(0.25) * stiffness;
          const V half =
              Simd::fma(Simd::set(0.25) * push * e, e, Simd::keep(alive, quarter * squares));
          const V half_loss = Simd::keep(alive, quarter * loss);
          energy            = energy + half;
          dissipated        = dissipated + half_loss;
          Simd::store(a.energy + q, Simd::load(a.energy + q) + half);
          Simd::store(bonds.dissipated + q, Simd::load(bonds.dissipated + q) + half_loss);
        }
      }
      Simd::store(fx + p, Simd::load(fx + p) + sx);
      Simd::store(fy + p, Simd::load(fy + p) + sy);
      Simd::store(fz + p, Simd::load(fz + p) + sz);
      if constexpr (with_energy)
      {
        Simd::store(a.energy + p, Simd::load(a.energy + p) + energy);
        Simd::store(bonds.dissipated + p, Simd::load(bonds.dissipated + p) + dissipated);
      }
    }
  }
}

template <class T, bool with_energy, bool weighted>
void relaxing_force(const LatticeArrays &a, const BondTable &table, const RelaxingBonds &bonds,
                    T *const history, const int64_t first, const int64_t last)
{
  if (bonds.n_branches == 1)
    relaxing_force<T, 1, with_energy, weighted>(a, table, bonds, history, first, last);
  else if (bonds.n_branches == 2)
    relaxing_force<T, 2, with_energy, weighted>(a, table, bonds, history, first, last);
  else
    relaxing_force<T, 0, with_energy, weighted>(a, table, bonds, history, first, last);
}

template <bool with_energy, bool weighted>
void relaxing_force(const LatticeArrays &a, const BondTable &table, const RelaxingBonds &bonds,
                    const int64_t first, const int64_t last)
{
  if (bonds.single_history != nullptr)
    relaxing_force<float, with_energy, weighted>(a, table, bonds, bonds.single_history, first,
                                                 last);
  else
    relaxing_force<double, with_energy, weighted>(a, table, bonds, bonds.double_history, first,
                                                  last);
}
} // namespace
} // namespace ricochet
