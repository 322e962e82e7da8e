// SPDX-License-Identifier: LGPL-2.1-or-later
// What every peridynamic bond law is made of. A law is a policy struct whose formulas are inlined
// into the lattice kernel (T = a SIMD vector) and into the family-by-family reference (T = double).
// This header and the laws must stay free of library headers: they are compiled once per
// instruction set.
#pragma once

namespace ricochet
{
/// By which a broken bond is too long once its ends have parted for good [spacings]. A choice, and
/// what hangs on it: doc/convergence.md.
constexpr double usual_parting_extension = 0.25;

/// What a law may use of one point's intact family in the bulk, and the isotropic moduli.
struct FamilyConstants
{
  double bulk_modulus;    // K [Pa]
  double shear_modulus;   // mu [Pa]
  double volume;          // V of a point [m^3]
  double weighted_volume; // m = sum omega |xi|^2 V, fixed at its bulk value for ever [m^5]
  double first_moment;    // sum omega |xi| V [m^4]
};

/// Numbers of one bond offset, the same for all points of a lattice.
struct BondConstants
{
  double length;     // |xi| [m]
  double critical;   // extension at which the bond breaks, s_c |xi| [m]
  double dilatation; // contribution to theta per extension [1/m]
  double volumetric; // tension per unit theta_i + theta_j [N]
  double extension;  // tension per unit extension [N/m]
};
} // namespace ricochet
