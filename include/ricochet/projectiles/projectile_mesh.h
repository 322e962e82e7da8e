// SPDX-License-Identifier: LGPL-2.1-or-later
// The hexahedra of a deformable projectile: generated, or read from a file and held against the
// declared shape.
#pragma once

#include "ricochet/geometry/hex_solid.h"
#include "ricochet/scene/scene.h"

namespace ricochet
{
/// In body axes, as generated or as the file holds it: whole, or in a symmetric scene perhaps the
/// half y >= 0 alone. Throws InputError if it does not fit the shape.
HexSolid given_mesh(const Scene &scene);

/// What is computed: the given mesh, of a symmetric scene its half y >= 0. Throws InputError.
HexSolid projectile_mesh(const Scene &scene);

/// Whether a given mesh is the half y >= 0 alone.
bool is_half(const HexSolid &mesh);
} // namespace ricochet
