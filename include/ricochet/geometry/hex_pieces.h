// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether the hexahedra of a solid hang together: nodes that coincide without being one, and pieces
// that share no face.
#pragma once

#include "ricochet/geometry/hex_solid.h"

#include <vector>

namespace ricochet
{
/// How many hexahedra each piece has, the largest first. Two belong to one piece if a chain of
/// hexahedra leads from one to the other, each sharing a face with the next.
std::vector<int> piece_sizes(const HexSolid &solid);

/// How many nodes of the hexahedra lie where another one does, to within `tolerance` [m].
int n_coincident_nodes(const HexSolid &solid, double tolerance);
} // namespace ricochet
