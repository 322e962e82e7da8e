// SPDX-License-Identifier: LGPL-2.1-or-later
// One double: for processors without AVX2, and the easiest of the three to read and to debug.
#pragma once

#include <math.h>
#include <stdint.h>

namespace ricochet
{
namespace
{
struct Simd
{
  using V = double;
  using M = unsigned int;

  static constexpr int width        = 1;
  static constexpr const char *name = "baseline";

  static V zero() { return 0.; }
  static V set(const double value) { return value; }
  static V load(const double *p) { return *p; }
  static void store(double *p, const V v) { *p = v; }
  static V load(const float *p) { return *p; }
  static void store(float *p, const V v) { *p = static_cast<float>(v); }
  static V gather(const double *base, const int32_t *index) { return base[*index]; } // base[index]
  static V fma(const V a, const V b, const V c) { return a * b + c; }
  static V fnma(const V a, const V b, const V c) { return c - a * b; }

  static M mask(const unsigned int bits) { return bits; }
  static unsigned int bits(const M mask) { return mask; }
  static bool any(const M mask) { return mask != 0; }
  static M greater(const V a, const V b, const M among) { return a > b ? among : 0u; }
  static V keep(const M mask, const V v) { return mask ? v : 0.; }
  static V inverse_sqrt(const V a) { return 1. / sqrt(a); }
};
} // namespace
} // namespace ricochet
