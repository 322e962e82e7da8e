// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a projectile's mesh, as contact wants it.
#pragma once

#include "ricochet/geometry/hex_solid.h"

namespace ricochet
{
/// Nodes on the outer faces only, numbered anew.
struct Skin
{
  std::vector<Vector3> nodes;     // in the reference configuration [m]
  std::vector<int> mesh_nodes;    // their numbers in the mesh
  std::vector<SurfaceQuad> faces; // by the new numbers

  Skin(const HexSolid &mesh, bool mirrored);
};

/// Faces of a mesh that points can touch: without those which the symmetry plane cuts open.
std::vector<SurfaceQuad> outer_faces(const HexSolid &mesh, bool mirrored);
} // namespace ricochet
