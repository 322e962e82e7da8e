// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/stress_state.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Matrix = Eigen::Matrix3d;

TEST(StressState, PressureIsPositiveUnderCompression)
{
  EXPECT_EQ(pressure(-5. * Matrix::Identity()), 5.);
  EXPECT_EQ(von_mises(-5. * Matrix::Identity()), 0.);
}

TEST(StressState, VonMisesStressIsThatOfSimpleTensionAndRootThreeTimesThatOfShear)
{
  Matrix tension = Matrix::Zero(), shear = Matrix::Zero();
  tension(1, 1) = 7.;
  shear(0, 2) = shear(2, 0) = 2.;
  EXPECT_NEAR(von_mises(tension), 7., 1e-14);
  EXPECT_NEAR(pressure(tension), -7. / 3., 1e-15);
  EXPECT_NEAR(von_mises(shear), 2. * std::sqrt(3.), 1e-15);
  EXPECT_EQ(pressure(shear), 0.);
}
} // namespace
} // namespace ricochet::tests
