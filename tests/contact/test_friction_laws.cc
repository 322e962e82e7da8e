// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <type_traits>

namespace ricochet::tests
{
namespace
{
class FrictionLawInvariant : public testing::TestWithParam<FrictionParameters>
{
};

INSTANTIATE_TEST_SUITE_P(Laws, FrictionLawInvariant, testing::ValuesIn(friction_law_samples),
                         [](const auto &info)
                         { return camel_case(FrictionLaws::name(info.param)); });

/// The value of the law's constant that parameter files call so; NaN if it has none.
double constant_called(const std::string &name, const FrictionParameters &parameters)
{
  double value = std::numeric_limits<double>::quiet_NaN();
  FrictionLaws::for_each(
      [&](const auto *law)
      {
        using Law = std::remove_const_t<std::remove_pointer_t<decltype(law)>>;
        if (const auto *const own = std::get_if<typename Law::Parameters>(&parameters))
          for (const auto &row : Law::entries)
            if (row.name == name)
              value = own->*row.member;
      });
  return value;
}

TEST_P(FrictionLawInvariant, CoefficientStartsAtTheStaticOneAndIsNeverNegative)
{
  const auto law                  = make_friction_law(GetParam());
  const double static_coefficient = constant_called("Static friction", GetParam());
  ASSERT_GT(static_coefficient, 0.);
  EXPECT_EQ(law->coefficient(0.), static_coefficient);
  for (double speed = 0.; speed < 2000.; speed += 10.)
  {
    EXPECT_GE(law->coefficient(speed), 0.);
    EXPECT_LE(law->coefficient(speed + 10.), law->coefficient(speed)); // never grows with the speed
  }
}

TEST(ExponentialFriction, FallsToTheKineticCoefficient)
{
  const ExponentialFriction law({0.4, 0.05, 0.01});
  // mu_inf + (mu_0 - mu_inf) exp(-gamma v)
  EXPECT_DOUBLE_EQ(law.coefficient(100.), 0.05 + 0.35 * std::exp(-1.));
  EXPECT_NEAR(law.coefficient(1e4), 0.05, 1e-15);
}

TEST(HyperbolicFriction, HalfOfTheWayIsLostAtTheInverseDecay)
{
  const HyperbolicFriction law({0.5, 0.1, 0.02});
  // mu_inf + (mu_0 - mu_inf)/(1 + gamma v)
  EXPECT_DOUBLE_EQ(law.coefficient(50.), 0.3);
  EXPECT_DOUBLE_EQ(law.coefficient(950.), 0.1 + 0.4 / 20.);
}

TEST(FlashHeatingFriction, FallsLikeTheInverseSpeedAboveTheWeakeningSpeed)
{
  const FlashHeatingFriction law({0.5, 0.1, 20.});
  // mu_w + (mu_0 - mu_w)/[1 + (v/V_w)^8]^(1/8): at V_w the way is lost by 2^(-1/8).
  EXPECT_DOUBLE_EQ(law.coefficient(20.), 0.1 + 0.4 * std::pow(2., -0.125));
  EXPECT_DOUBLE_EQ(law.coefficient(37.),
                   0.1 + 0.4 * std::pow(1. + std::pow(37. / 20., 8.), -0.125));
  // Rice's limits with the next term of the series in the eighth power of the ratio; the one after
  // it is of the order of 1e-17.
  EXPECT_DOUBLE_EQ(law.coefficient(2.), 0.1 + 0.4 * (1. - 1e-8 / 8.));
  EXPECT_DOUBLE_EQ(law.coefficient(200.), 0.1 + 0.4 * 0.1 * (1. - 1e-8 / 8.));
}

TEST(ConstantFriction, DoesNotDependOnTheSpeed)
{
  const ConstantFriction law({0.2});
  EXPECT_EQ(law.coefficient(1e3), 0.2);
}

TEST(FrictionLaws, ParametersSayWhichLawTheyBelongTo)
{
  EXPECT_EQ(FrictionLaws::name(HyperbolicFriction::Parameters{0.5, 0.1, 0.02}), "hyperbolic");
  const auto law = make_friction_law(HyperbolicFriction::Parameters{0.5, 0.1, 0.02});
  EXPECT_NE(dynamic_cast<const HyperbolicFriction *>(law.get()), nullptr);
}

/// Laws may share a constant by its name; then it must be the same thing in all of them.
TEST(FrictionLaws, SharedConstantsAreTheSameInAllLaws)
{
  std::map<std::string, std::string> meaning;
  std::map<std::string, std::pair<Dimension, Limit>> kind;
  FrictionLaws::for_each(
      [&](const auto *law)
      {
        using Law = std::remove_const_t<std::remove_pointer_t<decltype(law)>>;
        for (const auto &row : Law::entries)
        {
          EXPECT_EQ(meaning.try_emplace(row.name, row.meaning).first->second, row.meaning)
              << Law::name;
          const std::pair own(row.dimension, row.limit);
          EXPECT_EQ(kind.try_emplace(row.name, own).first->second, own) << Law::name;
        }
      });
  EXPECT_GE(meaning.size(), 3U); // static, kinetic, decay
}
} // namespace
} // namespace ricochet::tests
