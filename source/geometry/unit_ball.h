// SPDX-License-Identifier: LGPL-2.1-or-later
// How blocks of hexahedra fill the unit ball: a box with bulging faces in the middle, and a block
// from each of its faces to the sphere.
#pragma once

#include "ricochet/base/vector.h"

namespace ricochet
{
/// Half width of the inner box (and of the square in a disc), in radii.
constexpr double inner_half_width = 0.4;

/// A point of the inner box from u in [-1, 1]^3: its faces bulge towards the sphere.
Vector3 in_box(const Vector3 &u);

/// A point of the blocks around the box, on the ray through the face point u (largest component
/// +-1), at the share s of the way from the box to the sphere.
Vector3 around_box(const Vector3 &u, double s);
} // namespace ricochet
