// SPDX-License-Identifier: LGPL-2.1-or-later
// How a tangential force beside a face acts on the face's nodes.
#pragma once

#include "ricochet/geometry/faceted_surface.h"

namespace ricochet
{
/// Forces on the four nodes of a face that are equivalent to unit forces along the two tangents,
/// acting at the distance phi from the face's nearest point: N_a e_i plus a couple along n.
struct SurfaceTangents
{
  Vector3 direction[2];
  Vector3 on_node[2][4]; // [-]

  SurfaceTangents(const FacetedSurface &surface, const FacetedSurface::Hit &hit);

  /// Size of the velocity at a node by an impulse of size 1 along the face, per its 1/mass [-].
  double reach(int node) const;
};
} // namespace ricochet
