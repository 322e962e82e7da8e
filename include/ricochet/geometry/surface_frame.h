// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a projectile, or of several, at one moment, as pictures want it.
#pragma once

#include "ricochet/base/vector.h"

#include <array>
#include <vector>

namespace ricochet
{
/// A closed surface of quadrilaterals (for ParaView) and its outline in the plane y = 0 (for the
/// section picture); the same on all ranks.
struct SurfaceFrame
{
  std::vector<Vector3> vertices;         // current [m]
  std::vector<std::array<int, 4>> quads; // vertex numbers, around each
  std::vector<double> von_mises;         // of each of these [Pa]; none: not known
  std::vector<Vector3> outline;          // closed polygon [m]
  // Of several projectiles in one frame:
  std::vector<int> body = {}; // per quad: 0, -1, -2 and so on; without numbers all are 0
  std::vector<std::vector<Vector3>> further_outlines = {}; // of the second one and so on [m]

  /// Appends the frame of one more.
  void add(const SurfaceFrame &other);
};
} // namespace ricochet
