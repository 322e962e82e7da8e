// SPDX-License-Identifier: LGPL-2.1-or-later
// What the loops over eight-node elements share, on a SIMD type that the including file has defined
// before, see kernels/hex_kernel_loops.h.
//
// With corner coordinates r, s, t = +-1 the nodal values of a component are a sum of eight modes
// (1, r, s, t, st, rt, rs, rst); the fast Walsh-Hadamard transform gives all amplitudes, eight
// times, in 24 additions. Gradients need r, s, t, hourglass control the rest. Forces go back by the
// transpose.
#pragma once

#include <stdint.h>

namespace ricochet
{
namespace
{
constexpr int lanes      = Simd::width;
constexpr int block_size = 8;

using V = Simd::V;

enum Mode
{
  r,
  s,
  t,
  st,
  rt,
  rs,
  rst,
  n_modes
};

/// The values a + s b + t c + s t d at the four points s, t = +-1 in the order --, +-, -+, ++.
inline void at_four_points(const V a, const V b, const V c, const V d, V (&values)[4])
{
  const V low = a - b, high = a + b, low_t = c - d, high_t = c + d;
  values[0] = low - low_t;
  values[1] = high - high_t;
  values[2] = low + low_t;
  values[3] = high + high_t;
}

/// The transpose: sums of the values times 1, s, t and s t.
inline void moments_of_four_points(const V (&values)[4], V &one, V &first, V &second, V &product)
{
  const V sum_low = values[0] + values[1], sum_high = values[2] + values[3];
  const V difference_low = values[1] - values[0], difference_high = values[3] - values[2];
  one     = sum_high + sum_low;
  first   = difference_high + difference_low;
  second  = sum_high - sum_low;
  product = difference_high - difference_low;
}

/// Eight times the amplitude of each mode and component of the nodal values at `entry`.
inline void gather_modes(const double *values, const int32_t (&entry)[8][8], const int lane,
                         V (&mode)[3][n_modes])
{
  for (int c = 0; c < 3; ++c)
  {
    V even[4], odd[4], unused; // in r, of the edges along r
    for (int i = 0; i < 4; ++i)
    {
      const V low  = Simd::gather(values + c, entry[2 * i] + lane);
      const V high = Simd::gather(values + c, entry[2 * i + 1] + lane);
      even[i]      = high + low;
      odd[i]       = high - low;
    }
    moments_of_four_points(even, unused, mode[c][s], mode[c][t], mode[c][st]);
    moments_of_four_points(odd, mode[c][r], mode[c][rs], mode[c][rt], mode[c][rst]);
  }
}

/// Adds the nodal forces sum_m mode[m] Gamma_m to the elements of lanes `lane` to `end`. Neighbours
/// share nodes, so they are added one after the other.
inline void scatter(const V (&mode)[3][n_modes], const int32_t (&entry)[8][8], const int lane,
                    const int end, double *force)
{
  alignas(64) double nodal[3][8][lanes];
  for (int c = 0; c < 3; ++c)
  {
    V even[4], odd[4];
    at_four_points(Simd::zero(), mode[c][s], mode[c][t], mode[c][st], even);
    at_four_points(mode[c][r], mode[c][rs], mode[c][rt], mode[c][rst], odd);
    for (int i = 0; i < 4; ++i)
    {
      Simd::store(nodal[c][2 * i], even[i] - odd[i]);
      Simd::store(nodal[c][2 * i + 1], even[i] + odd[i]);
    }
  }
  for (int l = lane; l < end; ++l)
    for (int corner = 0; corner < 8; ++corner)
    {
      double *const f = force + entry[corner][l];
      for (int c = 0; c < 3; ++c)
        f[c] += nodal[c][corner][l - lane];
    }
}

/// A symmetric matrix: 11, 22, 33, 23, 13, 12.
struct Symmetric
{
  V a[6];
};

/// 2 E = F^T F - 1
inline Symmetric twice_green_strain(const V (&F)[3][3])
{
  constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
  Symmetric e;
  for (int i = 0; i < 6; ++i)
  {
    const int j = row[i], k = column[i];
    e.a[i] = Simd::fma(
        F[0][j], F[0][k],
        Simd::fma(F[1][j], F[1][k],
                  i < 3 ? Simd::fma(F[2][j], F[2][k], -Simd::set(1.)) : F[2][j] * F[2][k]));
  }
  return e;
}

/// P = F S, row of component c.
inline void first_piola_kirchhoff(const V (&F)[3], const Symmetric &S, V (&P)[3])
{
  P[0] = Simd::fma(F[0], S.a[0], Simd::fma(F[1], S.a[5], F[2] * S.a[4]));
  P[1] = Simd::fma(F[0], S.a[5], Simd::fma(F[1], S.a[1], F[2] * S.a[3]));
  P[2] = Simd::fma(F[0], S.a[4], Simd::fma(F[1], S.a[3], F[2] * S.a[2]));
}

/// 4 w = 2 S : E with the energy density w = S : E / 2.
inline V four_energy_densities(const Symmetric &S, const Symmetric &twice_e)
{
  const V normal =
      Simd::fma(S.a[0], twice_e.a[0], Simd::fma(S.a[1], twice_e.a[1], S.a[2] * twice_e.a[2]));
  const V shear =
      Simd::fma(S.a[3], twice_e.a[3], Simd::fma(S.a[4], twice_e.a[4], S.a[5] * twice_e.a[5]));
  return normal + shear + shear;
}
} // namespace
} // namespace ricochet
