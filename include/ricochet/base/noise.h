// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers that look random and are functions of a place alone: the same on any number of ranks.
#pragma once

#include "ricochet/base/vector.h"

#include <cmath>
#include <cstdint>

namespace ricochet
{
/// Uniform in [-1, 1], by SplitMix64 (Steele, Lea, Flood 2014, Fast splittable pseudorandom number
/// generators) of the place in quarters of its unit, and of a component.
inline double noise_at(const Vector3 &place, const int component)
{
  std::uint64_t z = 0x9e3779b97f4a7c15ull * (component + 1);
  for (int d = 0; d < 3; ++d)
  {
    z += static_cast<std::uint64_t>(std::llround(4. * place[d]) + 1000003);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
  }
  return 2. * static_cast<double>(z >> 11) / 9007199254740992. - 1.;
}
} // namespace ricochet
