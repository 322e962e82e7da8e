// SPDX-License-Identifier: LGPL-2.1-or-later
// Eight doubles and a mask register.
#pragma once

#include <immintrin.h>
#include <stdint.h>

namespace ricochet
{
namespace
{
struct Simd
{
  using V = __m512d;
  using M = __mmask8;

  static constexpr int width        = 8;
  static constexpr const char *name = "avx512";

  static V zero() { return _mm512_setzero_pd(); }
  static V set(const double value) { return _mm512_set1_pd(value); }
  static V load(const double *p) { return _mm512_loadu_pd(p); }
  static void store(double *p, const V v) { _mm512_storeu_pd(p, v); }
  static V load(const float *p) { return _mm512_maskz_cvtps_pd(0xff, _mm256_loadu_ps(p)); }
  static void store(float *p, const V v) { _mm256_storeu_ps(p, _mm512_maskz_cvtpd_ps(0xff, v)); }
  /// base[index[l]] in lane l.
  static V gather(const double *base, const int32_t *index)
  {
    return _mm512_mask_i32gather_pd(zero(), 0xff, _mm256_loadu_si256((const __m256i *) index), base,
                                    8);
  }
  static V fma(const V a, const V b, const V c) { return _mm512_fmadd_pd(a, b, c); }
  static V fnma(const V a, const V b, const V c) { return _mm512_fnmadd_pd(a, b, c); }

  static M mask(const unsigned int bits) { return M(bits); }
  static unsigned int bits(const M mask) { return mask; }
  static bool any(const M mask) { return mask != 0; }
  static M greater(const V a, const V b, const M among)
  {
    return _mm512_mask_cmp_pd_mask(among, a, b, _CMP_GT_OQ);
  }
  static V keep(const M mask, const V v) { return _mm512_maskz_mov_pd(mask, v); } // zero elsewhere

  /// 1/sqrt(a) to about one unit in the last place: the 14-bit estimate and the series of (1 -
  /// h)^(-1/2) to h^4.
  static V inverse_sqrt(const V a)
  {
    const V y = _mm512_maskz_rsqrt14_pd(0xff, a);
    const V h = fnma(a * y, y, set(1.));
    V p       = fma(h, set(35. / 128.), set(5. / 16.));
    p         = fma(h, p, set(3. / 8.));
    p         = fma(h, p, set(1. / 2.));
    return fma(y * h, p, y);
  }
};
} // namespace
} // namespace ricochet
