// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/number_text.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

namespace ricochet
{
namespace
{
/// What printf makes of it: users' scripts have seen nothing else.
std::string printed(const char *const format, const int n, const double value)
{
  char text[400]; // enough for the largest number written out
  std::snprintf(text, sizeof text, format, n, value);
  return text;
}

TEST(NumberText, EqualsThatOfPrintf)
{
  for (const double value :
       {0., -0., 1. / 3., -12345.678, 9.9996, 1e-7, 123456789., 1e22,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(),
        std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const int n : {0, 1, 4, 10})
    {
      EXPECT_EQ(with_decimals(value, n), printed("%.*f", n, value));
      EXPECT_EQ(with_digits(value, n), printed("%.*g", n, value));
      EXPECT_EQ(with_exponent(value, n), printed("%.*e", n, value));
    }
}

TEST(NumberText, PrecisionDoesNotDependOnTheUnit)
{
  EXPECT_EQ(with_precision(287.4, 3), "287");
  EXPECT_EQ(with_precision(1287.4, 3), "1287");
  EXPECT_EQ(with_precision(-1.3331, 3), "-1.33");
  EXPECT_EQ(with_precision(0.012345, 3), "0.0123");
  EXPECT_EQ(with_precision(0., 3), "0");
  EXPECT_EQ(with_precision(std::numeric_limits<double>::quiet_NaN(), 3), "nan");
  EXPECT_EQ(with_precision(std::numeric_limits<double>::infinity(), 3), "inf");
}

TEST(NumberText, ZerosFillUpAndNeverCutOff)
{
  EXPECT_EQ(with_zeros(7, 4), "0007");
  EXPECT_EQ(with_zeros(12345, 4), "12345");
}
} // namespace
} // namespace ricochet
