// SPDX-License-Identifier: LGPL-2.1-or-later
// Single points of a lattice's fields.
#pragma once

#include "ricochet/base/vector.h"

#include <cstddef>

namespace ricochet
{
inline Vector3 at(const double *const field[3], const std::ptrdiff_t p)
{
  return {field[0][p], field[1][p], field[2][p]};
}

/// x and z first: they dismiss most points of a plate.
inline bool is_outside(const double *const position[3], const std::ptrdiff_t p, const Vector3 &low,
                       const Vector3 &high)
{
  for (const int d : {0, 2, 1})
    if (position[d][p] < low[d] || position[d][p] > high[d])
      return true;
  return false;
}

inline Vector3 vector(const double (&x)[3])
{
  return {x[0], x[1], x[2]};
}
} // namespace ricochet
