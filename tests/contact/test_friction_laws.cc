// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/laws.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ricochet::tests
{
namespace
{
class FrictionLawInvariant : public testing::TestWithParam<FrictionParameters>
{
};

INSTANTIATE_TEST_SUITE_P(Laws, FrictionLawInvariant, testing::ValuesIn(friction_law_samples),
                         [](const auto &info) { return camel_case(info.param.law); });

TEST_P(FrictionLawInvariant, CoefficientStartsAtTheStaticOneAndIsNeverNegative)
{
  const auto law = make_friction_law(GetParam());
  EXPECT_EQ(law->coefficient(0.), GetParam().static_coefficient);
  for (double speed = 0.; speed < 2000.; speed += 10.)
  {
    EXPECT_GE(law->coefficient(speed), 0.);
    EXPECT_LE(law->coefficient(speed + 10.), law->coefficient(speed)); // never grows with the speed
  }
}

TEST(ExponentialFriction, FallsToTheKineticCoefficient)
{
  const auto law = make_friction_law({"exponential", 0.4, 0.05, 0.01, 5.});
  // mu_inf + (mu_0 - mu_inf) exp(-gamma v)
  EXPECT_DOUBLE_EQ(law->coefficient(100.), 0.05 + 0.35 * std::exp(-1.));
  EXPECT_NEAR(law->coefficient(1e4), 0.05, 1e-15);
}

TEST(HyperbolicFriction, HalfOfTheWayIsLostAtTheInverseDecay)
{
  const auto law = make_friction_law({"hyperbolic", 0.5, 0.1, 0.02, 5.});
  // mu_inf + (mu_0 - mu_inf)/(1 + gamma v)
  EXPECT_DOUBLE_EQ(law->coefficient(50.), 0.3);
  EXPECT_DOUBLE_EQ(law->coefficient(950.), 0.1 + 0.4 / 20.);
}

TEST(ConstantFriction, DoesNotDependOnTheSpeed)
{
  const auto law = make_friction_law({"constant", 0.2, 0.1, 0.5, 5.});
  EXPECT_EQ(law->coefficient(1e3), 0.2);
}

TEST(FrictionLaws, UnknownNameListsTheMenu)
{
  try
  {
    make_friction_law({"soap", 0.1, 0.1, 0., 5.});
    FAIL() << "no error";
  }
  catch (const InputError &error)
  {
    for (const auto &entry : friction_laws())
      EXPECT_NE(std::string(error.what()).find(entry.name), std::string::npos) << error.what();
  }
}
} // namespace
} // namespace ricochet::tests
