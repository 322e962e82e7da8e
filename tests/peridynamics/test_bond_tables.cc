// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exceptions.h"
#include "ricochet/peridynamics/bond_tables.h"
#include "support/laws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
const Lattice::Box box{Vector3::Zero(), 1e-3, {7, 7, 7}, false};

TEST(BondTables, LimitsAreTheOnlyDifference)
{
  const Lattice lattice(box, make_stencil(1e-3, 3., InfluenceFunction::constant), 0, 1);
  const auto &offsets = lattice.stencil().offsets;
  for (const auto &law : bond_law_samples)
  {
    const BondTables tables(lattice, {&bond_law(law.law), law.density, law.bulk_modulus,
                                      law.shear_modulus, /*critical_stretch=*/0.02});
    for (const BondTable *table : {&tables.breakable(), &tables.unbreakable()})
    {
      ASSERT_EQ(table->n, int(offsets.size()));
      EXPECT_EQ(table->point_stiffness, bond_law(law.law).point_stiffness(tables.family()));
    }
    for (std::size_t k = 0; k < offsets.size(); ++k)
    {
      const auto &weak   = tables.breakable().constants[k],
                 &strong = tables.unbreakable().constants[k];
      EXPECT_EQ(tables.breakable().shift[k], lattice.shift(offsets[k]));
      EXPECT_DOUBLE_EQ(weak.critical, 0.02 * offsets[k].length);
      EXPECT_TRUE(std::isinf(strong.critical));
      EXPECT_EQ(weak.length, offsets[k].length);
      EXPECT_EQ(weak.length, strong.length);
      EXPECT_EQ(weak.extension, strong.extension);
      EXPECT_EQ(weak.dilatation, strong.dilatation);
      EXPECT_GT(weak.extension, 0.);
    }
  }
}

TEST(BondTables, OnePerCentOfTheShearModulusIsForgivenToABondBasedLaw)
{
  const Lattice lattice(box, make_stencil(1e-3, 3., InfluenceFunction::constant), 0, 1);
  const auto make = [&](const double factor)
  {
    const auto &law = bond_law_samples[1];
    BondTables(lattice, {&bond_law(law.law), law.density, law.bulk_modulus,
                         factor * 0.6 * law.bulk_modulus, 0.02});
  };
  EXPECT_NO_THROW(make(1.009));
  EXPECT_NO_THROW(make(0.991));
  EXPECT_THROW(make(1.011), InputError);
  EXPECT_THROW(make(0.989), InputError);
}
} // namespace
} // namespace ricochet::tests
