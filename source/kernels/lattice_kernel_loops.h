// SPDX-License-Identifier: LGPL-2.1-or-later
// The loops behind kernels/lattice_kernel.h, written once on a SIMD type. Each including file
// defines, in an unnamed namespace before this header, a struct Simd of its instruction set (see
// kernels/simd_avx512.h for its members), so that nothing compiled here is visible outside that
// file.
#pragma once

#include "flow_loop.h"
#include "relaxing_force_loop.h"
#include "ricochet/kernels/lattice_kernel.h"
#include "ricochet/materials/bond_law_list.h"

namespace ricochet
{
namespace
{
/// Which of the bonds `bits` from p ... to q ... break: longer than `critical`, and no end held.
inline unsigned int beyond_limit(const LatticeArrays &a, const int64_t p, const int64_t q,
                                 const V &e, const double critical, const unsigned int bits)
{
  const M broken    = Simd::greater(e, Simd::set(critical), Simd::mask(bits));
  unsigned int gone = Simd::bits(broken);
  if (gone != 0 && a.hold != nullptr) // rarely
    gone &= ~Simd::bits(
        Simd::greater(Simd::load(a.hold + p) + Simd::load(a.hold + q), Simd::zero(), broken));
  return gone;
}

/// Counts bonds extended by more than `limit` [m] at both ends: those `alive` either way, those of
/// `pushing` if shortened.
inline void count_strained(const LatticeArrays &a, const int64_t p, const int64_t q, const V &e,
                           const double limit, const M &alive, const M &pushing)
{
  const unsigned int strained = Simd::bits(Simd::greater(-e, Simd::set(limit), pushing)) |
                                Simd::bits(Simd::greater(e, Simd::set(limit), alive));
  if (strained == 0)
    return;
  const V one = Simd::keep(Simd::mask(strained), Simd::set(1.));
  add_to(a.strained + p, one);
  add_to(a.strained + q, one);
}

/// stretch() of one block; `failing`: some of its bonds are cracked or have flowed. Returns the end
/// of the log.
template <class Law, bool failing>
BrokenBonds *stretch_block(const LatticeArrays &a, const BondTable &table, const int64_t block,
                           BrokenBonds *log)
{
  const double *const x = a.position[0], *const y = a.position[1], *const z = a.position[2];
  uint8_t *const bonds       = a.bonds + block * table.n;
  uint8_t *const cracked     = a.cracked != nullptr ? a.cracked + block * table.n : nullptr;
  const float *const plastic = failing ? plastic_of(a, table, block) : nullptr;
  for (int lane = 0; lane < block_size; lane += lanes)
  {
    const int64_t p = block * block_size + lane;
    const V px = Simd::load(x + p), py = Simd::load(y + p), pz = Simd::load(z + p);
    V theta = Simd::zero();
    for (int k = 0; k < table.n; ++k)
    {
      const unsigned int bits   = lane_bits(bonds[k], lane);
      const unsigned int cracks = failing && cracked != nullptr ? lane_bits(cracked[k], lane) : 0;
      if ((bits | cracks) == 0)
        continue;
      const int64_t q        = p + table.shift[k];
      const BondConstants &c = table.constants[k];
      const V dx = Simd::load(x + q) - px, dy = Simd::load(y + q) - py, dz = Simd::load(z + q) - pz;
      const V r2    = Simd::fma(dx, dx, Simd::fma(dy, dy, dz * dz));
      const V whole = Simd::fma(r2, Simd::inverse_sqrt(r2), -Simd::set(c.length));
      V e           = whole;
      if (failing && plastic != nullptr)
        e = e - Simd::load(plastic + k * block_size + lane);
      const unsigned int gone = beyond_limit(a, p, q, e, c.critical, bits);
      unsigned int parted     = gone;
      if (cracked != nullptr && (cracks | gone) != 0)
        parted = Simd::bits(Simd::greater(e, Simd::set(table.parting), Simd::mask(cracks | gone)));
      if ((gone | parted) != 0) // rarely
      {
        bonds[k] &= uint8_t(~(gone << lane));
        if (cracked != nullptr)
          cracked[k] = uint8_t((cracked[k] | (gone << lane)) & ~(parted << lane));
        *log++ = {int32_t(block), int16_t(k), uint8_t(gone << lane), uint8_t(parted << lane)};
      }
      const M alive = Simd::mask(bits & ~gone);
      if (a.strained != nullptr)
        count_strained(a, p, q, e, table.yield_stretch * c.length, alive,
                       Simd::mask((bits & ~gone) | cracks));
      if constexpr (Law::has_dilatation)
      {
        const V part = Simd::keep(alive, whole * Simd::set(c.dilatation));
        theta        = theta + part;
        add_to(a.theta + q, part);
      }
    }
    if constexpr (Law::has_dilatation)
      add_to(a.theta + p, theta);
  }
  return log;
}

template <class Law>
int64_t stretch(const LatticeArrays &a, const BondTable &table, const int64_t first,
                const int64_t last, BrokenBonds *const log)
{
  BrokenBonds *end = log;
  for (int64_t block = first; block < last; ++block)
    end = is_failing(a, table, block) ? stretch_block<Law, true>(a, table, block, end)
                                      : stretch_block<Law, false>(a, table, block, end);
  return end - log;
}

/// force() of one block; `failing`: some of its bonds are cracked or have flowed.
template <class Law, bool with_energy, bool weighted, bool failing>
void force_of_block(const LatticeArrays &a, const BondTable &table, const int64_t block)
{
  const double *const x = a.position[0], *const y = a.position[1], *const z = a.position[2];
  double *const fx = a.force[0], *const fy = a.force[1], *const fz = a.force[2];
  const uint8_t *const bonds   = a.bonds + block * table.n;
  const uint8_t *const cracked = a.cracked != nullptr ? a.cracked + block * table.n : nullptr;
  const float *const plastic   = failing ? plastic_of(a, table, block) : nullptr;
  for (int lane = 0; lane < block_size; lane += lanes)
  {
    const int64_t p = block * block_size + lane;
    const V px = Simd::load(x + p), py = Simd::load(y + p), pz = Simd::load(z + p);
    const V theta = Simd::load(a.theta + p);
    V sx = Simd::zero(), sy = Simd::zero(), sz = Simd::zero(), energy = Simd::zero();
    V own_half = Simd::zero();
    if constexpr (weighted)
      own_half = Simd::load(a.half_weight + p);
    for (int k = 0; k < table.n; ++k)
    {
      const unsigned int bits   = lane_bits(bonds[k], lane);
      const unsigned int cracks = failing && cracked != nullptr ? lane_bits(cracked[k], lane) : 0;
      if ((bits | cracks) == 0)
        continue;
      const int64_t q        = p + table.shift[k];
      const BondConstants &c = table.constants[k];
      const M alive          = Simd::mask(bits);
      const V dx = Simd::load(x + q) - px, dy = Simd::load(y + q) - py, dz = Simd::load(z + q) - pz;
      const V r2      = Simd::fma(dx, dx, Simd::fma(dy, dy, dz * dz));
      const V inverse = Simd::inverse_sqrt(r2);
      V e             = Simd::fma(r2, inverse, -Simd::set(c.length));
      if (failing && plastic != nullptr)
        e = e - Simd::load(plastic + k * block_size + lane);
      V extension = Simd::set(c.extension);
      if constexpr (weighted)
        extension = extension * (own_half + Simd::load(a.half_weight + q));
      const V tension = Law::template tension<V>(Simd::set(c.volumetric), extension, e,
                                                 theta + Simd::load(a.theta + q));
      V t             = Simd::keep(alive, tension * inverse);
      V push          = Simd::zero();
      if (failing && cracks != 0)
      {
        push = stiffness_of_closed(cracks, e, Simd::set(table.cracked_share) * extension);
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
        const V half = Simd::fma(
            Simd::set(0.25) * push * e, e,
            Simd::keep(alive, Simd::set(0.5) * Law::template bond_energy<V>(extension, e)));
        energy = energy + half;
        Simd::store(a.energy + q, Simd::load(a.energy + q) + half);
      }
    }
    Simd::store(fx + p, Simd::load(fx + p) + sx);
    Simd::store(fy + p, Simd::load(fy + p) + sy);
    Simd::store(fz + p, Simd::load(fz + p) + sz);
    if constexpr (with_energy)
    {
      // w theta^2 = (w theta)^2 / w; without weight theta is zero.
      V stiffness = Simd::set(table.point_stiffness);
      if constexpr (weighted)
        stiffness = stiffness / (own_half + own_half + Simd::set(1e-30));
      Simd::store(a.energy + p,
                  Simd::fma(stiffness, theta * theta, Simd::load(a.energy + p) + energy));
    }
  }
}

template <class Law, bool with_energy, bool weighted>
void force(const LatticeArrays &a, const BondTable &table, const int64_t first, const int64_t last)
{
  for (int64_t block = first; block < last; ++block)
    if (is_failing(a, table, block))
      force_of_block<Law, with_energy, weighted, true>(a, table, block);
    else
      force_of_block<Law, with_energy, weighted, false>(a, table, block);
}

inline void advance(const LatticeArrays &a, const int64_t first, const int64_t last,
                    const double dt_over_mass, const double dt)
{
  const V kick = Simd::set(dt_over_mass), drift = Simd::set(dt);
  for (int64_t block = first; block < last; ++block)
    for (int lane = 0; lane < block_size; lane += lanes)
    {
      const int64_t p = block * block_size + lane;
      const M free    = Simd::mask(lane_bits(a.free[block], lane));
      for (int d = 0; d < 3; ++d)
      {
        const V v = Simd::keep(
            free, Simd::fma(kick, Simd::load(a.force[d] + p), Simd::load(a.velocity[d] + p)));
        Simd::store(a.velocity[d] + p, v);
        Simd::store(a.position[d] + p, Simd::fma(drift, v, Simd::load(a.position[d] + p)));
      }
    }
}

template <class Law>
constexpr LatticeKernel kernel_of()
{
  return {Simd::name,
          block_size / lanes,
          &stretch<Law>,
          &force<Law, false, false>,
          &force<Law, true, false>,
          &force<Law, false, true>,
          &force<Law, true, true>,
          Law::has_dilatation ? &relaxing_force<false, false> : nullptr,
          Law::has_dilatation ? &relaxing_force<true, false> : nullptr,
          Law::has_dilatation ? &relaxing_force<false, true> : nullptr,
          Law::has_dilatation ? &relaxing_force<true, true> : nullptr,
          &flow<false>,
          &flow<true>,
          &advance};
}

#define RICOCHET_KERNEL(Law) kernel_of<Law>(),
const LatticeKernel kernels[] = {RICOCHET_BOND_LAWS(RICOCHET_KERNEL)};
#undef RICOCHET_KERNEL
} // namespace
} // namespace ricochet
