// SPDX-License-Identifier: LGPL-2.1-or-later
// The cubes of a HexMesh as a forest of deal.II, before nodes are numbered.
#pragma once

#include "ricochet/finite_elements/hex_mesh.h"

#include <deal.II/distributed/tria.h>

namespace ricochet
{
using Triangulation = dealii::parallel::distributed::Triangulation<3>;

/// Throws InputError for an empty box, and a region that misses it or has no extent.
void check_box(const HexMesh::Box &box);

/// How often all three counts can be halved: these levels are left to the tree of cells, because
/// every rank stores all roots of the forest but only its share of the trees.
int n_common_halvings(std::array<int, 3> n);

/// Throws InputError for more roots than HexMesh::max_coarse_cells. Collective.
void create_cells(Triangulation &triangulation, const HexMesh::Box &box, int halvings);

/// Cubes are shared among the ranks by what they cost. Collective.
void share_cells(Triangulation &triangulation, const HexMesh::Box &box, int halvings);

/// Throws InputError if there are more ranks than elements.
std::int64_t checked_number_of_elements(const Triangulation &triangulation);
} // namespace ricochet
