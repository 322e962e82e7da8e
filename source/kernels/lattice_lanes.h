// SPDX-License-Identifier: LGPL-2.1-or-later
// What the lattice loops share. As kernels/lattice_kernel_loops.h, to be included behind a struct
// Simd.
#pragma once

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
} // namespace
} // namespace ricochet
