// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/elastic_constants.h"

#include <gtest/gtest.h>

namespace ricochet
{
namespace
{
TEST(ElasticConstants, AgreeWithAKnownMaterial)
{
  // Round numbers that can be checked by hand: E = 6, nu = 1/5 give K = 6/(3 * 3/5) = 10/3 and
  // mu = 6/(2 * 6/5) = 5/2.
  EXPECT_DOUBLE_EQ(bulk_modulus(6., 0.2), 10. / 3.);
  EXPECT_DOUBLE_EQ(shear_modulus(6., 0.2), 2.5);
  EXPECT_DOUBLE_EQ(youngs_modulus(10. / 3., 2.5), 6.);
  EXPECT_DOUBLE_EQ(poissons_ratio(10. / 3., 2.5), 0.2);
}

TEST(ElasticConstants, GoThereAndBack)
{
  for (const double nu : {-0.9, -0.3, 0., 0.25, 0.33, 0.49})
    for (const double E : {1., 6e9, 202e9})
    {
      const double K = bulk_modulus(E, nu), mu = shear_modulus(E, nu);
      EXPECT_NEAR(youngs_modulus(K, mu), E, 1e-14 * E); // some roundings
      EXPECT_NEAR(poissons_ratio(K, mu), nu, 1e-13);    // 3 K - 2 mu cancels by up to 1/20
    }
}

TEST(ElasticConstants, BondBasedSolidHasAQuarter)
{
  EXPECT_DOUBLE_EQ(poissons_ratio(40e9, 24e9), 0.25); // mu = 3 K/5
}

TEST(ElasticConstants, FormsOfPoissonsRatioRoundAlike)
{
  for (const double K : {5.9e9, 40e9, 0.123456789})
    for (const double mu : {2.258e9, 24e9, 0.0987654321})
      EXPECT_EQ(poissons_ratio(K, mu), (3. * K - 2. * mu) / (6. * K + 2. * mu));
}
} // namespace
} // namespace ricochet
