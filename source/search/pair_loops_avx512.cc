// SPDX-License-Identifier: LGPL-2.1-or-later
// The pair loops for one instruction set; CMakeLists.txt gives this file its own compiler flags.
#include <immintrin.h>
#include <stdint.h>

#include "ricochet/search/pair_loops.h"

namespace ricochet
{
namespace
{
struct Lanes
{
  using F = __m512;
  using I = __m512i;

  static constexpr int width        = 16;
  static constexpr const char *name = "avx512";

  static F set(const float value) { return _mm512_set1_ps(value); }
  static I set(const int32_t value) { return _mm512_set1_epi32(value); }
  static F load(const float *p) { return _mm512_loadu_ps(p); }
  static unsigned int less(const F a, const F b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  static unsigned int equal(const int32_t *a, const I b)
  {
    return _mm512_cmpeq_epi32_mask(_mm512_loadu_si512(a), b);
  }
  static unsigned int negative(const int32_t *a)
  {
    return _mm512_cmplt_epi32_mask(_mm512_loadu_si512(a), _mm512_setzero_si512());
  }

  /// The pairs of `first` with those of second[0 ... 15] that `chosen` has a bit for.
  static PointPair *append(PointPair *out, const int32_t first, const int32_t *second,
                           const unsigned int chosen)
  {
    const I a       = set(first);
    const I b       = _mm512_maskz_compress_epi32(__mmask16(chosen), _mm512_loadu_si512(second));
    const int n     = __builtin_popcount(chosen);
    const I low     = _mm512_set_epi32(7, 16, 6, 16, 5, 16, 4, 16, 3, 16, 2, 16, 1, 16, 0, 16);
    const I upwards = _mm512_set_epi32(8, 0, 8, 0, 8, 0, 8, 0, 8, 0, 8, 0, 8, 0, 8, 0);
    _mm512_storeu_si512(out, _mm512_permutex2var_epi32(b, low, a));
    if (n > 8)
      _mm512_storeu_si512(out + 8, _mm512_permutex2var_epi32(b, _mm512_add_epi32(low, upwards), a));
    return out + n;
  }
};
} // namespace
} // namespace ricochet

#include "pair_loops_body.h"

namespace ricochet
{
extern const PairLoops *const pair_loops_avx512;
const PairLoops *const pair_loops_avx512 = &loops;
} // namespace ricochet
