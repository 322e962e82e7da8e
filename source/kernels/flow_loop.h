// SPDX-License-Identifier: LGPL-2.1-or-later
// Flow of bonds, and what tells where the material yields. As kernels/lattice_kernel_loops.h, to be
// included behind a struct Simd. peridynamics/bond_flow.h says what the sums are.
#pragma once

#include "lattice_lanes.h"
#include "ricochet/kernels/lattice_kernel.h"

namespace ricochet
{
namespace
{
/// |x_q - x_p| - |xi| one step ago.
inline V extension_before(const LatticeArrays &a, const int64_t p, const int64_t q, const V &dx,
                          const V &dy, const V &dz, const double length, const double dt)
{
  const double *const u = a.velocity[0], *const v = a.velocity[1], *const w = a.velocity[2];
  const V back = Simd::set(-dt);
  const V x    = Simd::fma(back, Simd::load(u + q) - Simd::load(u + p), dx),
          y    = Simd::fma(back, Simd::load(v + q) - Simd::load(v + p), dy),
          z    = Simd::fma(back, Simd::load(w + q) - Simd::load(w + p), dz);
  const V r2   = Simd::fma(x, x, Simd::fma(y, y, z * z));
  return Simd::fma(r2, Simd::inverse_sqrt(r2), -Simd::set(length));
}

/// A bond of each lane.
struct FlowingBond
{
  V dx, dy, dz, plastic; // from one end to the other, plastic part of its extension [m]
  V e;                   // elastic extension [m]
  M alive, closed;       // intact; a crack that is closed
  V intact, push;        // their u, zero of others [m]
};

/// What flows in the step of the bonds from p ...; `target`: of the share `rate` of u [m]. Returns
/// the work of it, over half the stiffness [m^2].
inline V let_flow(const LatticeArrays &a, const int64_t p, const int64_t q, const V &rate,
                  const V &target, const double length, const double dt, const V &cracked_share,
                  FlowingBond &bond, float *const entry)
{
  const V none  = Simd::zero();
  const V slip  = Simd::keep(bond.alive, Simd::fma(rate, bond.intact, -target)),
          crush = Simd::keep(bond.closed, Simd::fma(rate, bond.push, -target) / cracked_share);
  Simd::store(entry, bond.plastic + (slip + crush));
  const V then   = extension_before(a, p, q, bond.dx, bond.dy, bond.dz, length, dt) - bond.plastic;
  const V pushed = Simd::keep(bond.closed, bond.e - crush);
  const V still  = Simd::keep(Simd::greater(none, pushed, bond.closed), pushed),
          pushed_then = Simd::keep(Simd::greater(none, then, bond.closed), then);
  bond.intact         = bond.intact - slip;
  bond.push           = cracked_share * still;
  // The mean of the tensions before and after, c.extension times e each, times what has flowed.
  return Simd::fma(slip, then + bond.e - slip, cracked_share * crush * (still + pushed_then));
}

template <bool weighted>
void flow(const LatticeArrays &a, const BondTable &table, const FlowingBonds &f,
          const int64_t first, const int64_t last)
{
  const double *const x = a.position[0], *const y = a.position[1], *const z = a.position[2];
  const V none = Simd::zero(), cracked_share = Simd::set(table.cracked_share);
  for (int64_t block = first; block < last; ++block)
    for (int lane = 0; lane < block_size; lane += lanes)
    {
      const int64_t p = block * block_size + lane;
      const V px = Simd::load(x + p), py = Simd::load(y + p), pz = Simd::load(z + p);
      const V relaxing = Simd::load(f.relaxing + p), mean = Simd::load(f.mean + p);
      V carrying = none, sum = none, square = none, dissipated = none;
      for (int k = 0; k < table.n; ++k)
      {
        const int64_t at          = block * table.n + k;
        const unsigned int bits   = lane_bits(a.bonds[at], lane);
        const unsigned int cracks = a.cracked != nullptr ? lane_bits(a.cracked[at], lane) : 0;
        if ((bits | cracks) == 0)
          continue;
        const int64_t q        = p + table.shift[k];
        const BondConstants &c = table.constants[k];
        float *const entry     = f.plastic + at * block_size + lane;
        FlowingBond bond;
        bond.dx      = Simd::load(x + q) - px;
        bond.dy      = Simd::load(y + q) - py;
        bond.dz      = Simd::load(z + q) - pz;
        bond.plastic = Simd::load(entry);
        const V r2   = Simd::fma(bond.dx, bond.dx, Simd::fma(bond.dy, bond.dy, bond.dz * bond.dz));
        bond.e       = Simd::fma(r2, Simd::inverse_sqrt(r2), -Simd::set(c.length)) - bond.plastic;
        bond.alive   = Simd::mask(bits);
        bond.closed  = Simd::greater(none, bond.e, Simd::mask(cracks));
        V both       = Simd::load(a.theta + p) + Simd::load(a.theta + q),
          stiffness  = Simd::set(c.extension);
        if constexpr (weighted) // theta stands for w theta
        {
          const V w = Simd::load(a.half_weight + p) + Simd::load(a.half_weight + q);
          both      = both / (w + Simd::set(1e-30));
          stiffness = stiffness * w;
        }
        bond.intact =
            Simd::keep(bond.alive, Simd::fma(Simd::set(c.volumetric / c.extension), both, bond.e));
        bond.push = cracked_share * Simd::keep(bond.closed, bond.e);

        const V other = Simd::load(f.relaxing + q), rate = relaxing + other;
        if (Simd::any(Simd::greater(rate, none, Simd::mask(bits | cracks))))
        {
          // Of each end's deviatoric part its own share; half of the work to either end.
          const V target =
              Simd::set(c.length) * Simd::fma(relaxing, mean, other * Simd::load(f.mean + q));
          const V half =
              Simd::set(0.25) * stiffness *
              let_flow(a, p, q, rate, target, c.length, f.dt, cracked_share, bond, entry);
          dissipated = dissipated + half;
          add_to(f.dissipated + q, half);
        }

        const V u = bond.intact + bond.push, one = Simd::set(c.dilatation * c.length);
        const V carries   = Simd::keep(bond.alive, one) + Simd::keep(bond.closed, one),
                of_sum    = Simd::set(c.dilatation) * u,
                of_square = Simd::set(0.25 * c.extension) * u * u;
        carrying          = carrying + carries;
        sum               = sum + of_sum;
        square            = square + of_square;
        add_to(f.carrying + q, carries);
        add_to(f.sum + q, of_sum);
        add_to(f.square + q, of_square);
      }
      add_to(f.carrying + p, carrying);
      add_to(f.sum + p, sum);
      add_to(f.square + p, square);
      add_to(f.dissipated + p, dissipated);
    }
}
} // namespace
} // namespace ricochet
