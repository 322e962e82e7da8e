// SPDX-License-Identifier: LGPL-2.1-or-later
// The bonds of one point of a cubic lattice: half of the offsets within the horizon, the other half
// being their negatives. Offsets, lengths and weights are the same for all points, so no neighbour
// list exists.
#pragma once

#include "ricochet/materials/bond_laws.h"
#include "ricochet/materials/finite_element_material.h"
#include "ricochet/materials/influence_function.h"

#include <array>
#include <vector>

namespace ricochet
{
struct Stencil
{
  /// One of the bonds.
  struct Offset
  {
    int x, y, z;   // in spacings; x > 0, or x = 0 and z > 0, or x = z = 0 and y > 0
    double length; // |xi| [m]
    double omega;  // influence function [-]
  };

  double spacing;    // dx [m]
  double horizon;    // delta [m]
  int reach;         // largest offset along an axis, in spacings
  int squared_range; // largest x^2 + y^2 + z^2 of an offset; everything below it is in the stencil
  std::vector<Offset> offsets; // the forward half
};

/// All offsets with 0 < |xi| <= horizon_ratio * spacing and omega > 0. Throws InputError for a
/// ratio below 1 or above 8.
Stencil make_stencil(double spacing, double horizon_ratio, InfluenceFunction influence_function);

/// Sums over the intact bulk family that the bond laws need.
FamilyConstants family_constants(const Stencil &stencil, double bulk_modulus, double shear_modulus);

/// Energy of all bonds across a unit area, each at the stretch 1, in a medium pulled normal to it
/// [J/m^2]: the critical stretch is sqrt(G_c / this). Summed over the lattice. For the microelastic
/// law with omega = 1 and a full sphere it is 9 K delta/5, Silling and Askari 2005, equation 27.
double fracture_energy_per_squared_stretch(const Stencil &stencil, const BondLaw &law,
                                           double bulk_modulus, double shear_modulus);

/// A lattice is a cubic solid, not quite an isotropic one: its moduli against uniform strain, from
/// Born's sum over the bonds, C_ij = sum t_j n_i n_i |xi| / V with t_j the tension under unit
/// strain j (Born and Huang 1954, section 11). The bulk modulus is the one given.
CubicAnisotropy lattice_anisotropy(const Stencil &stencil, const BondLaw &law, double bulk_modulus,
                                   double shear_modulus);
} // namespace ricochet
