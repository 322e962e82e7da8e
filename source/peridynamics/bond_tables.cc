// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_tables.h"

#include "ricochet/base/exceptions.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace ricochet
{
namespace
{
void check_moduli(const PeridynamicMaterial &material)
{
  if (!material.law->fixes_poisson_ratio ||
      std::abs(material.shear_modulus - 0.6 * material.bulk_modulus) <=
          0.01 * material.shear_modulus)
    return;
  std::ostringstream message;
  message << "The bond model '" << material.law->name
          << "' has Poisson's ratio 1/4, that is mu = 3K/5 = " << 0.6e-9 * material.bulk_modulus
          << " GPa; the material asks for mu = " << 1e-9 * material.shear_modulus
          << " GPa. Use 'linear peridynamic solid' or change the shear modulus.";
  throw InputError(message.str());
}
} // namespace

BondTables::BondTables(const Lattice &lattice, const PeridynamicMaterial &material) :
  family_(family_constants(lattice.stencil(), material.bulk_modulus, material.shear_modulus)),
  shifts_(lattice.shifts())
{
  check_moduli(material);
  for (const auto &offset : lattice.stencil().offsets)
  {
    BondConstants c = material.law->bond(family_, offset.length, offset.omega);
    c.critical      = std::numeric_limits<double>::infinity();
    unbreakable_constants_.push_back(c);
    c.critical = material.critical_stretch * offset.length;
    breakable_constants_.push_back(c);
  }
  const double point_stiffness = material.law->point_stiffness(family_);
  const int n                  = static_cast<int>(shifts_.size());
  const double cracked_share =
      (3. * material.bulk_modulus + 4. * material.shear_modulus) / (9. * material.shear_modulus);
  const double parting   = material.parting_extension * lattice.stencil().spacing;
  breakable_             = {n,
                            shifts_.data(),
                            breakable_constants_.data(),
                            point_stiffness,
                            cracked_share,
                            parting,
                            least_yielding_stretch(material.flow, material.shear_modulus)};
  unbreakable_           = breakable_;
  unbreakable_.constants = unbreakable_constants_.data();
  unbreakable_.parting   = std::numeric_limits<double>::infinity();
}
} // namespace ricochet
