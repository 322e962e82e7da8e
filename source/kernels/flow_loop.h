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

inline void flow(const LatticeArrays &a, const BondTable &table, const FlowingBonds &f,
                 const int64_t first, const int64_t last)
{
  const double *const x = a.position[0], *const y = a.position[1], *const z = a.position[2];
  const V none = Simd::zero(), share = Simd::set(table.cracked_share);
  for (int64_t block = first; block < last; ++block)
  {
    const uint8_t *const bonds   = a.bonds + block * table.n;
    const uint8_t *const cracked = a.cracked != nullptr ? a.cracked + block * table.n : nullptr;
    for (int lane = 0; lane < block_size; lane += lanes)
    {
      const int64_t p = block * block_size + lane;
      const V px = Simd::load(x + p), py = Simd::load(y + p), pz = Simd::load(z + p);
      const V theta = Simd::load(a.theta + p), relaxing = Simd::load(f.relaxing + p),
              mean = Simd::load(f.mean + p);
      V carrying = none, sum = none, square = none, dissipated = none;
      for (int k = 0; k < table.n; ++k)
      {
        const unsigned int bits   = lane_bits(bonds[k], lane);
        const unsigned int cracks = cracked != nullptr ? lane_bits(cracked[k], lane) : 0;
        if ((bits | cracks) == 0)
          continue;
        const int64_t q        = p + table.shift[k];
        const BondConstants &c = table.constants[k];
        const M alive          = Simd::mask(bits);
        const V dx = Simd::load(x + q) - px, dy = Simd::load(y + q) - py,
                dz         = Simd::load(z + q) - pz;
        const V r2         = Simd::fma(dx, dx, Simd::fma(dy, dy, dz * dz));
        float *const entry = f.plastic + (block * table.n + k) * block_size + lane;
        const V plastic    = Simd::load(entry);
        const V e          = Simd::fma(r2, Simd::inverse_sqrt(r2), -Simd::set(c.length)) - plastic;
        const M closed     = Simd::greater(none, e, Simd::mask(cracks));

        // u of intact bonds, and of closed cracks.
        const V both = theta + Simd::load(a.theta + q);
        V intact     = Simd::keep(alive, Simd::fma(Simd::set(c.volumetric / c.extension), both, e));
        V push       = share * Simd::keep(closed, e);
        const V rate = relaxing + Simd::load(f.relaxing + q);
        const bool any = Simd::any(Simd::greater(rate, none, Simd::mask(bits | cracks)));
        if (any)
        {
          // Of each end's deviatoric part its own share.
          const V target =
              Simd::set(c.length) *
              Simd::fma(relaxing, mean, Simd::load(f.relaxing + q) * Simd::load(f.mean + q));
          const V slip  = Simd::keep(alive, rate * intact - target),
                  crush = Simd::keep(closed, (rate * push - target) / share);
          Simd::store(entry, plastic + (slip + crush));
          const V then   = extension_before(a, p, q, dx, dy, dz, c.length, f.dt) - plastic;
          const V pushed = Simd::keep(closed, e - crush);
          const V still  = Simd::keep(Simd::greater(none, pushed, closed), pushed);
          intact         = intact - slip;
          push           = share * still;
          // Half of it to either end; the tensions are c.extension times e, before and after.
          const V work =
              slip * (then + e - slip) +
              share * crush * (still + Simd::keep(Simd::greater(none, then, closed), then));
          const V half = Simd::set(0.25 * c.extension) * work;
          dissipated   = dissipated + half;
          add_to(f.dissipated + q, half);
        }

        const V u              = intact + push;
        const V one            = Simd::set(c.dilatation * c.length);
        const V carries        = Simd::keep(alive, one) + Simd::keep(closed, one);
        const V part           = Simd::set(c.dilatation) * u,
                part_of_square = Simd::set(0.25 * c.extension) * u * u;
        carrying               = carrying + carries;
        sum                    = sum + part;
        square                 = square + part_of_square;
        add_to(f.carrying + q, carries);
        add_to(f.sum + q, part);
        add_to(f.square + q, part_of_square);
      }
      add_to(f.carrying + p, carrying);
      add_to(f.sum + p, sum);
      add_to(f.square + p, square);
      add_to(f.dissipated + p, dissipated);
    }
  }
}
} // namespace
} // namespace ricochet
