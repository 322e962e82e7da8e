// SPDX-License-Identifier: LGPL-2.1-or-later
// The pair loops for one instruction set; CMakeLists.txt gives this file its own compiler flags.
#include <immintrin.h>
#include <stdint.h>

#include "ricochet/search/pair_loops.h"

namespace ricochet
{
namespace
{
/// Row m: the positions of the bits of m, the rest is filled up with zeros.
struct CompressionTable
{
  int32_t row[256][8] = {};

  constexpr CompressionTable()
  {
    for (int mask = 0; mask < 256; ++mask)
      for (int lane = 0, n = 0; lane < 8; ++lane)
        if ((mask >> lane) & 1)
          row[mask][n++] = lane;
  }
};
constexpr CompressionTable compression;

struct Lanes
{
  using F = __m256;
  using I = __m256i;

  static constexpr int width        = 8;
  static constexpr const char *name = "avx2";

  static F set(const float value) { return _mm256_set1_ps(value); }
  static I set(const int32_t value) { return _mm256_set1_epi32(value); }
  static F load(const float *p) { return _mm256_loadu_ps(p); }
  static I load(const int32_t *p) { return _mm256_loadu_si256((const __m256i *) p); }
  static unsigned int bits(const F mask) { return _mm256_movemask_ps(mask); }
  static unsigned int less(const F a, const F b) { return bits(_mm256_cmp_ps(a, b, _CMP_LT_OQ)); }
  static unsigned int equal(const int32_t *a, const I b)
  {
    return bits(_mm256_castsi256_ps(_mm256_cmpeq_epi32(load(a), b)));
  }
  static unsigned int negative(const int32_t *a) { return bits(_mm256_castsi256_ps(load(a))); }

  /// The pairs of `first` with those of second[0 ... 7] that `chosen` has a bit for.
  static PointPair *append(PointPair *out, const int32_t first, const int32_t *second,
                           const unsigned int chosen)
  {
    const I a    = set(first);
    const I b    = _mm256_permutevar8x32_epi32(load(second), load(compression.row[chosen]));
    const I low  = _mm256_unpacklo_epi32(a, b);
    const I high = _mm256_unpackhi_epi32(a, b);
    _mm256_storeu_si256((__m256i *) out, _mm256_permute2x128_si256(low, high, 0x20));
    _mm256_storeu_si256((__m256i *) (out + 4), _mm256_permute2x128_si256(low, high, 0x31));
    return out + __builtin_popcount(chosen);
  }
};
} // namespace
} // namespace ricochet

#include "pair_loops_body.h"

namespace ricochet
{
extern const PairLoops *const pair_loops_avx2;
const PairLoops *const pair_loops_avx2 = &loops;
} // namespace ricochet
