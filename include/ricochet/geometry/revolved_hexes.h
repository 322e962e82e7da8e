// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of revolution cut into hexahedra. The shank is an extruded disc: a square surrounded by
// four blocks. The nose is half a ball, a box surrounded by five blocks, whose points (s, theta) go
// to s (x(theta), r(x)) with the profile r(x) of the nose and x = l (1 - 2 theta/pi): with x linear
// in theta the cells at a sharp tip stay hexahedra. Symmetric about y = 0 and z = 0.
#pragma once

#include "ricochet/geometry/body_of_revolution.h"
#include "ricochet/geometry/hex_solid.h"

namespace ricochet
{
/// `refinement` 1 to 4: each doubles the cells along every edge; 4 * 2^refinement edges lie around
/// the circumference. With its nodes on the surface the body would be too slim and its tip too
/// soft: radii are enlarged so that the polygon of the shank has the circle's area and the facets
/// of the nose lie as far outside the shape as inside. In body axes, tip towards x, with the
/// analytic body's centroid as the origin.
HexSolid revolved_hexes(const BodyOfRevolution &body, int refinement);
} // namespace ricochet
