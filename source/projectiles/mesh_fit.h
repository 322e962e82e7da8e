// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether a mesh is that of a body of revolution: in one piece, of its size, whole or the half that
// is computed, about the x axis, with the tip at the upper end, of its radius everywhere along the
// axis, of its volume.
#pragma once

#include "ricochet/geometry/body_of_revolution.h"
#include "ricochet/geometry/hex_solid.h"

namespace ricochet
{
/// The mesh in body axes: its base moved to that of the body, nodes on the plane of a half exactly
/// on it. Its half y >= 0 alone will do in a symmetric scene. Throws InputError, which says in what
/// it differs from the body and how to mend that.
HexSolid fitted(HexSolid mesh, const BodyOfRevolution &body, bool symmetric);
} // namespace ricochet
