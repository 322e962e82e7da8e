// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/body.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(Body, MomentaAddUp)
{
  Momenta sum{Vector3(1., 2., 3.), Vector3(4., 5., 6.)};
  sum += 2. * sum;
  EXPECT_EQ(sum.linear, Vector3(3., 6., 9.));
  EXPECT_EQ(sum.angular, Vector3(12., 15., 18.));
}
} // namespace
} // namespace ricochet::tests
