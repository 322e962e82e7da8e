// SPDX-License-Identifier: LGPL-2.1-or-later
// The bond laws as seen by everything that is not a kernel: chosen by name, one bond at a time, in
// doubles.
#pragma once

#include "ricochet/materials/bond_law.h"

#include <string>
#include <vector>

namespace ricochet
{
/// One bond law with its formulas as plain functions; see materials/linear_peridynamic_solid.h for
/// their meaning.
struct BondLaw
{
  const char *name;         // in parameter files
  int index;                // position in the menu, as the kernels number it
  bool has_dilatation;      // whether tensions depend on theta
  bool fixes_poisson_ratio; // at 1/4
  /// Constants of a bond of a length [m] and an influence function [-].
  BondConstants (*bond)(const FamilyConstants &, double length, double omega);
  double (*point_stiffness)(const FamilyConstants &);                           // [J]
  double (*tension)(const BondConstants &, double extension, double theta_sum); // [N]
  double (*bond_energy)(const BondConstants &, double extension);               // [J]
};

/// The menu.
const std::vector<BondLaw> &bond_laws();

/// The law of that name. Throws InputError which lists the menu.
const BondLaw &bond_law(const std::string &name);

/// The names in the order of the menu.
std::vector<std::string> bond_law_names();
} // namespace ricochet
