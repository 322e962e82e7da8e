// SPDX-License-Identifier: LGPL-2.1-or-later
// Four doubles; masks are vectors of all ones or zeros.
#pragma once

#include <immintrin.h>
#include <stdint.h>

namespace ricochet
{
namespace
{
struct Simd
{
  using V = __m256d;
  using M = __m256d;

  static constexpr int width        = 4;
  static constexpr const char *name = "avx2";

  static V zero() { return _mm256_setzero_pd(); }
  static V set(const double value) { return _mm256_set1_pd(value); }
  static V load(const double *p) { return _mm256_loadu_pd(p); }
  static void store(double *p, const V v) { _mm256_storeu_pd(p, v); }
  static V load(const float *p) { return _mm256_cvtps_pd(_mm_loadu_ps(p)); }
  static void store(float *p, const V v) { _mm_storeu_ps(p, _mm256_cvtpd_ps(v)); }
  /// base[index[l]] in lane l.
  static V gather(const double *base, const int32_t *index)
  {
    const __m256d all = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
    return _mm256_mask_i32gather_pd(zero(), base, _mm_loadu_si128((const __m128i *) index), all, 8);
  }
  static V fma(const V a, const V b, const V c) { return _mm256_fmadd_pd(a, b, c); }
  static V fnma(const V a, const V b, const V c) { return _mm256_fnmadd_pd(a, b, c); }

  static M mask(const unsigned int bits)
  {
    const __m256i lane = _mm256_set_epi64x(8, 4, 2, 1);
    return _mm256_castsi256_pd(
        _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(bits), lane), lane));
  }
  static unsigned int bits(const M mask) { return _mm256_movemask_pd(mask); }
  static bool any(const M mask) { return _mm256_movemask_pd(mask) != 0; }
  static M greater(const V a, const V b, const M among)
  {
    return _mm256_and_pd(among, _mm256_cmp_pd(a, b, _CMP_GT_OQ));
  }
  static V keep(const M mask, const V v) { return _mm256_and_pd(mask, v); }

  /// 1/sqrt(a) to about two units in the last place: the 12-bit single precision estimate and two
  /// steps of third order. Squared bond lengths (1e-10 ... 1 m^2) are well inside the range of
  /// single precision.
  static V inverse_sqrt(const V a)
  {
    V y = _mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(a)));
    for (int i = 0; i < 2; ++i)
    {
      const V h = fnma(a * y, y, set(1.));
      y         = fma(y * h, fma(h, set(3. / 8.), set(1. / 2.)), y);
    }
    return y;
  }
};
} // namespace
} // namespace ricochet
