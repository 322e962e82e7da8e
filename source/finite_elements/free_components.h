// SPDX-License-Identifier: LGPL-2.1-or-later
// The unknowns of a free body's vibration, and which of them share an element.
#pragma once

#include "ricochet/finite_elements/hexahedral_body.h"

namespace ricochet
{
/// Free components are numbered on, three per node; -1 where the mirror plane holds one.
std::vector<int> number_free(const HexahedralBody &body);

/// Free components, less those of rigid motion.
int degrees_of_freedom(const HexahedralBody &body);

/// Of each node those that share a cell with it, itself included, ascending. Throws InputError if
/// the cells are several loose parts.
std::vector<std::vector<int>> neighbours_of(const HexahedralBody &body);
} // namespace ricochet
