// SPDX-License-Identifier: LGPL-2.1-or-later
// What the lattice loops share. As kernels/lattice_kernel_loops.h, to be included behind a struct
// Simd.
#pragma once

#include "ricochet/kernels/lattice_kernel.h"

#include <stdint.h>

namespace ricochet
{
namespace
{
constexpr int lanes      = Simd::width;
constexpr int block_size = 8;

using V = Simd::V;
using M = Simd::M;

/// Which of the points p ... p + lanes - 1 of block byte `bits` take part.
inline unsigned int lane_bits(const uint8_t bits, const int lane)
{
  return (bits >> lane) & ((1u << lanes) - 1);
}

/// [offset][lane] of a block, or null if none of its bonds has flowed.
inline const float *plastic_of(const LatticeArrays &a, const BondTable &table, const int64_t block)
{
  return a.flowed != nullptr && a.flowed[block] ? a.plastic + block * table.n * block_size
                                                : nullptr;
}

/// Whether any bond of a block is cracked or has flowed: most blocks have none, and loops that need
/// not look are faster.
inline bool is_failing(const LatticeArrays &a, const BondTable &table, const int64_t block)
{
  if (a.flowed != nullptr && a.flowed[block])
    return true;
  if (a.cracked == nullptr)
    return false;
  const uint8_t *const cracked = a.cracked + block * table.n;
  unsigned int any             = 0;
  for (int k = 0; k < table.n; ++k)
    any |= cracked[k];
  return any != 0;
}

/// `stiffness` of the cracks that are closed: of the bonds `cracks` with e < 0.
inline V stiffness_of_closed(const unsigned int cracks, const V &e, const V &stiffness)
{
  return Simd::keep(Simd::greater(Simd::zero(), e, Simd::mask(cracks)), stiffness);
}

/// field[0 ... lanes - 1] += value
inline void add_to(double *const field, const V &value)
{
  Simd::store(field, Simd::load(field) + value);
}
} // namespace
} // namespace ricochet
