// SPDX-License-Identifier: LGPL-2.1-or-later
// The pair loops for every x86-64 processor.
#include <emmintrin.h>
#include <stdint.h>

#include "ricochet/search/pair_loops.h"

namespace ricochet
{
namespace
{
struct Lanes
{
  using F = __m128;
  using I = __m128i;

  static constexpr int width        = 4;
  static constexpr const char *name = "baseline";

  static F set(const float value) { return _mm_set1_ps(value); }
  static I set(const int32_t value) { return _mm_set1_epi32(value); }
  static F load(const float *p) { return _mm_loadu_ps(p); }
  static I load(const int32_t *p) { return _mm_loadu_si128((const __m128i *) p); }
  static unsigned int bits(const F mask) { return _mm_movemask_ps(mask); }
  static unsigned int less(const F a, const F b) { return bits(_mm_cmplt_ps(a, b)); }
  static unsigned int equal(const int32_t *a, const I b)
  {
    return bits(_mm_castsi128_ps(_mm_cmpeq_epi32(load(a), b)));
  }
  static unsigned int negative(const int32_t *a) { return bits(_mm_castsi128_ps(load(a))); }

  /// The pairs of `first` with those of second[0 ... 3] that `chosen` has a bit for.
  static PointPair *append(PointPair *out, const int32_t first, const int32_t *second,
                           const unsigned int chosen)
  {
    // Without branches: every pair is written, those not chosen are written over.
    for (int lane = 0; lane < width; ++lane)
    {
      *out = {first, second[lane]};
      out += (chosen >> lane) & 1;
    }
    return out;
  }
};
} // namespace
} // namespace ricochet

#include "pair_loops_body.h"

namespace ricochet
{
extern const PairLoops *const pair_loops_baseline;
const PairLoops *const pair_loops_baseline = &loops;
} // namespace ricochet
