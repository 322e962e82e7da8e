// SPDX-License-Identifier: LGPL-2.1-or-later
// What a plate lacks from the start: holes and notches, and the cracks it has. In the plate's own
// coordinates, all in [m]: x from its near edge, y from its mid-plane, and as the third the depth
// below its upper face.
#pragma once

#include "ricochet/base/vector.h"

#include <array>
#include <vector>

namespace ricochet
{
struct Cutouts
{
  /// A cylinder through the plate.
  struct Hole
  {
    double x, y, diameter;
  };
  /// A box.
  struct Notch
  {
    double x_from, x_to, y_from, y_to, depth_from, depth_to;
  };
  /// A rectangle across x (normal 0) or y (normal 1).
  struct Crack
  {
    int normal;
    double at, from, to; // along the normal, and along the other of x and y
    double depth_from, depth_to;
  };

  std::vector<Hole> holes    = {}; // cylinders through the plate
  std::vector<Notch> notches = {}; // boxes without material
  std::vector<Crack> cracks  = {}; // rectangles that no bond crosses

  /// Whether there is none.
  bool empty() const { return holes.empty() && notches.empty() && cracks.empty(); }
  /// Whether there is no material; on the border there is.
  bool removes(const Vector3 &point) const;
  /// Whether the straight line from one point to the other crosses a crack. A point in the plane of
  /// a crack is on the far side of it.
  bool severs(const Vector3 &one, const Vector3 &other) const;
  /// x from and to, y from and to of each of them.
  std::vector<std::array<double, 4>> columns() const;
};

/// See Cutouts::removes().
bool removes(const Cutouts::Hole &hole, const Vector3 &point);
/// Likewise.
bool removes(const Cutouts::Notch &notch, const Vector3 &point);
/// See Cutouts::severs().
bool severs(const Cutouts::Crack &crack, const Vector3 &one, const Vector3 &other);

/// Its own mirror image at y = 0.
bool is_symmetric(const Cutouts::Hole &hole);
/// Likewise.
bool is_symmetric(const Cutouts::Notch &notch);
/// Likewise.
bool is_symmetric(const Cutouts::Crack &crack);
/// x from and to, y from and to.
std::array<double, 4> column_of(const Cutouts::Hole &hole);
/// Likewise.
std::array<double, 4> column_of(const Cutouts::Notch &notch);
/// Likewise.
std::array<double, 4> column_of(const Cutouts::Crack &crack);
} // namespace ricochet
