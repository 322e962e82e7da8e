// SPDX-License-Identifier: LGPL-2.1-or-later
// What is reported of contact: every field has one unit, and records of several plates add up.
#include "ricochet/contact/contact_record.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
ContactRecord sample(const double scale)
{
  ContactRecord record;
  record.normal          = scale * Vector3(1., 2., 3.);
  record.friction        = scale * Vector3(-4., 5., 6.);
  record.shank           = scale * Vector3(7., -8., 9.);
  record.moment          = scale * Vector3(0.1, 0.2, 0.3);
  record.friction_moment = scale * Vector3(0.4, 0.5, 0.6);
  record.energy          = scale * 10.;
  record.n_touching      = scale * 11.;
  return record;
}

TEST(ContactRecord, ForcesMomentsEnergiesAndNumbersAddUp)
{
  ContactRecord sum;
  EXPECT_EQ(sum.force(), Vector3::Zero());
  sum += sample(1.);
  sum += sample(2.);
  const auto expected = sample(3.);
  EXPECT_EQ(sum.normal, expected.normal);
  EXPECT_EQ(sum.friction, expected.friction);
  EXPECT_EQ(sum.shank, expected.shank);
  EXPECT_LT((sum.moment - expected.moment).norm(), 1e-15);
  EXPECT_LT((sum.friction_moment - expected.friction_moment).norm(), 1e-15);
  EXPECT_EQ(sum.energy, expected.energy);
  EXPECT_EQ(sum.n_touching, expected.n_touching);
  EXPECT_EQ(sum.force(), Vector3(3. * 4., 3. * -1., 3. * 18.));
}

TEST(ContactRecord, DeepestPointsAreComparedInTheirOwnUnit)
{
  // The point of a coarse plate is the deepest in metres, that of a fine one in spacings.
  ContactRecord coarse, fine;
  coarse.deepest             = 0.4e-3;
  coarse.deepest_in_spacings = 0.4;
  fine.deepest               = 0.3e-3;
  fine.deepest_in_spacings   = 1.2;
  for (auto [sum, other] : {std::pair(coarse, fine), std::pair(fine, coarse)})
  {
    sum += other;
    EXPECT_EQ(sum.deepest, 0.4e-3);
    EXPECT_EQ(sum.deepest_in_spacings, 1.2);
  }
}

TEST(ContactRecord, OnePointOnElementsIsEnough)
{
  ContactRecord none, some;
  some.on_elements = true;
  ContactRecord sum;
  sum += none;
  EXPECT_FALSE(sum.on_elements);
  sum += some;
  sum += none;
  EXPECT_TRUE(sum.on_elements);
}
} // namespace
} // namespace ricochet::tests
