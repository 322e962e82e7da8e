// SPDX-License-Identifier: LGPL-2.1-or-later
// The constants of a body's bonds, which are the same for all its points: one entry per offset of
// the stencil, in its order. Linear peridynamic solid: Silling et al. 2007, J. Elasticity 88;
// microelastic brittle: Silling and Askari 2005, Computers and Structures 83.
//
// A bond that breaks loses its tension for good. It may go on to resist compression, as the faces
// of a closed crack do (unilateral damage, Chaboche 1992, Int. J. Damage Mech. 1):
// shortened, it pushes with the share
//   (K + 4 mu/3) / (3 mu)
// of its stiffness 30 mu omega V^2/m. In a family of such bonds alone that is a solid of Poisson's
// ratio 1/4 with the modulus K + 4 mu/3 of the whole material in plane compression, so that a
// closed crack lets a longitudinal wave pass. Its ends have parted, and meet as strangers from
// then on, once it is too long by a share of the spacing: opened so far, or slid past each other by
// as much as makes that.
#pragma once

#include "ricochet/kernels/lattice_kernel.h"
#include "ricochet/peridynamics/lattice.h"
#include "ricochet/peridynamics/peridynamic_material.h"

#include <vector>

namespace ricochet
{
class BondTables
{
public:
  /// Throws InputError if the law cannot represent the moduli.
  BondTables(const Lattice &lattice, const PeridynamicMaterial &material);
  // The tables point into the vectors.
  BondTables(const BondTables &)            = delete;
  BondTables &operator=(const BondTables &) = delete;

  /// Sums over a full family [m, Pa].
  const FamilyConstants &family() const { return family_; }
  /// For kernels: with the limit at which bonds break, and without.
  const BondTable &breakable() const { return breakable_; }
  /// The same without limits: nothing breaks.
  const BondTable &unbreakable() const { return unbreakable_; }
  /// The same constants, limits s_c |xi| [m] and infinite.
  const std::vector<BondConstants> &breakable_constants() const { return breakable_constants_; }
  /// Per offset of the stencil.
  const std::vector<BondConstants> &unbreakable_constants() const { return unbreakable_constants_; }

private:
  FamilyConstants family_;
  std::vector<std::int64_t> shifts_; // of the flat index
  std::vector<BondConstants> breakable_constants_, unbreakable_constants_;
  BondTable breakable_, unbreakable_;
};
} // namespace ricochet
