// SPDX-License-Identifier: LGPL-2.1-or-later
// Apart from coupling/clamped_edges.h, so that a scene can name them without finite elements.
#pragma once

namespace ricochet
{
/// Which side faces of a plate are held.
enum class ClampedSides
{
  none,
  ends,  // those across the flight
  sides, // those along it
  all
};
} // namespace ricochet
