// SPDX-License-Identifier: LGPL-2.1-or-later
// Which elements a gmsh file holds, looked up before it is read: a mesh of others than hexahedra is
// refused in words, with the setting of gmsh that makes it usable.
#pragma once

#include <map>
#include <string>

namespace ricochet
{
/// How many elements of each of gmsh's types.
using GmshElementCounts = std::map<int, long>;

/// Of the text of a file in format 2.2 or 4.1 ASCII; if it breaks off, of what there is.
GmshElementCounts count_elements(const std::string &text);

/// Whether nodes in the text carry their parameters on curves and surfaces as well.
bool has_parametric_nodes(const std::string &text);

/// Throws InputError, which begins with the name of the `file` and counts what cannot be used,
/// unless there are hexahedra with 8 nodes and besides them nothing but what may bound them:
/// quadrangles, lines and points of first order.
void require_hexahedra(const std::string &file, const GmshElementCounts &counts);
} // namespace ricochet
