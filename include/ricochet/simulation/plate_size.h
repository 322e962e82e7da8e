// SPDX-License-Identifier: LGPL-2.1-or-later
// How large a plate is when points, and elements around them, have filled it: each extent becomes a
// multiple of the grid spacing, or of the largest elements.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/scene/scene.h"

#include <array>
#include <vector>

namespace ricochet
{
/// An extent may change by this share; more would be another plate. 5 % of the thickness are 16 %
/// of the stiffness in bending. Without elements an extent is off by half a spacing at most, which
/// is more than 5 % only if it holds fewer than ten points [-].
constexpr double most_rounding = 0.05;

/// Points along x, y and z of a plate, of its half with a symmetry plane; with elements a multiple
/// of what their largest cubes hold. Throws InputError if that changes an extent by more than
/// `most_rounding`.
std::array<int, 3> lattice_points(const Scene &scene, const PlateParameters &plate);

/// How often the elements of a plate double their size.
int coarsening_levels(const Scene &scene, const PlateParameters &plate);

/// Extents of a whole plate along the flight, across it and in depth [m].
struct PlateSize
{
  Vector3 asked;    // by the file
  Vector3 computed; // on this grid

  /// Whether they are the same but for rounding of numbers.
  bool is_as_asked() const;
};

/// Of all plates of a scene, from top to bottom. Throws InputError like lattice_points().
std::vector<PlateSize> plate_sizes(const Scene &scene);

/// "199.5 x 99 x 30 mm"
std::string size_text(const Vector3 &size);
} // namespace ricochet
