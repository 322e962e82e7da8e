// SPDX-License-Identifier: LGPL-2.1-or-later
// Under the free faces of a plate points are softer than inside, in two layers of different
// thickness.
#pragma once

#include "ricochet/peridynamics/lattice.h"

#include <algorithm>
#include <limits>

namespace ricochet
{
/// Of a reference position below the nearest free face of the plate; a symmetry plane is none [m].
inline double depth_in_plate(const Lattice::Box &box, const Vector3 &X)
{
  const Vector3 low  = X - box.corner,
                high = box.spacing * Vector3(box.n[0], box.n[1], box.n[2]) - low;
  double depth       = std::numeric_limits<double>::infinity();
  for (int d = 0; d < 3; ++d)
    depth = std::min(depth, d == 1 && box.mirror_y ? high[d] : std::min(low[d], high[d]));
  return depth;
}

/// In the surface layer, one horizon thick, points lack neighbours.
inline bool in_surface_layer(const Lattice &lattice, const Vector3 &X)
{
  return depth_in_plate(lattice.box(), X) < lattice.stencil().horizon * (1. - 1e-9);
}

/// In the softened layer, of twice the reach of the bonds, points lack neighbours or have
/// neighbours that do, and with a law that knows dilatation feel it.
inline bool in_softened_layer(const Lattice &lattice, const Vector3 &X)
{
  return depth_in_plate(lattice.box(), X) <
         2. * lattice.stencil().reach * lattice.box().spacing * (1. + 1e-9);
}
} // namespace ricochet
