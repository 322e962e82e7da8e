// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ricochet/finite_elements/hex_mesh.h"

#include <vector>

namespace ricochet
{
/// The diagonal mass M_L of a body of elements: an eighth of each element at each of its corners.
/// Hanging nodes carry none, they hand it on to their masters.
struct LumpedMass
{
  std::vector<double> mass;    // per owned node; zero where no active element is [kg]
  std::vector<double> inverse; // per component of owned nodes; zero where it is held [1/kg]
};

/// Of the elements for which `active` (one entry each) is true. Held are u_y on the mirror plane
/// and the components in `fixed` (entries of `inverse`). Collective.
LumpedMass lumped_mass(const HexMesh &mesh, double density, const std::vector<char> &active,
                       const std::vector<int> &fixed);
} // namespace ricochet
