// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/vector.h"
#include "ricochet/base/voigt.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(Voigt, NumbersAndPlacesAreInverseToEachOther)
{
  for (int k = 0; k < voigt::n; ++k)
  {
    EXPECT_LE(voigt::row[k], voigt::column[k]);
    EXPECT_EQ(voigt::number[voigt::row[k]][voigt::column[k]], k);
    EXPECT_EQ(voigt::number[voigt::column[k]][voigt::row[k]], k);
    EXPECT_EQ(voigt::is_shear(k), voigt::row[k] != voigt::column[k]);
  }
  // 11, 22, 33, 23, 13, 12
  EXPECT_EQ(voigt::number[1][2], 3);
  EXPECT_EQ(voigt::number[0][2], 4);
  EXPECT_EQ(voigt::number[0][1], 5);
}

TEST(Voigt, WorkIsTheProductOfStressAndEngineeringStrain)
{
  Eigen::Matrix3d S, E; // any symmetric ones
  S << 3., -1., 4., -1., 5., -9., 4., -9., 2.;
  E << -2., 7., 1., 7., -8., 2., 1., 2., 8.;
  double work = 0.;
  for (int k = 0; k < voigt::n; ++k)
  {
    const double strain = E(voigt::row[k], voigt::column[k]) * (voigt::is_shear(k) ? 2. : 1.);
    work += S(voigt::row[k], voigt::column[k]) * strain;
  }
  EXPECT_DOUBLE_EQ(work, S.cwiseProduct(E).sum());
}
} // namespace
} // namespace ricochet::tests
