// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/quantity.h"
#include "scene/entry_patterns.h"

#include <gtest/gtest.h>

namespace ricochet
{
namespace
{
struct Sample
{
  const char *text;
  Dimension dimension;
  double si;
};

class QuantityUnits : public testing::TestWithParam<Sample>
{
};

TEST_P(QuantityUnits, AreConvertedToSi)
{
  const Sample sample = GetParam();
  const auto parsed   = parse_quantity(sample.text, sample.dimension, Limit::any);
  EXPECT_EQ(parsed.problem, "") << sample.text;
  EXPECT_NEAR(parsed.value, sample.si, 1e-14 * std::abs(sample.si)) << sample.text; // rounding only
}

INSTANTIATE_TEST_SUITE_P(
    All, QuantityUnits,
    testing::Values(
        Sample{"30 mm", Dimension::length, 0.03}, Sample{"0.3 in", Dimension::length, 7.62e-3},
        Sample{"50 um", Dimension::length, 50e-6}, Sample{"3 cm", Dimension::length, 0.03},
        Sample{"-1 m", Dimension::length, -1.}, Sample{"5.9 GPa", Dimension::stress, 5.9e9},
        Sample{"5.9GPa", Dimension::stress, 5.9e9}, Sample{"500 MPa", Dimension::stress, 500e6},
        Sample{"2 kPa", Dimension::stress, 2e3}, Sample{"1e5 Pa", Dimension::stress, 1e5},
        Sample{"720 m/s", Dimension::speed, 720.}, Sample{"0.72 mm/us", Dimension::speed, 720.},
        Sample{"0.72 km/s", Dimension::speed, 720.}, Sample{"1000 ft/s", Dimension::speed, 304.8},
        Sample{"0.72 mm/\u00b5s", Dimension::speed, 720.},
        Sample{"180 deg", Dimension::angle, 3.14159265358979323846},
        Sample{"90\u00b0", Dimension::angle, 1.57079632679489661923},
        Sample{"0.5 rad", Dimension::angle, 0.5},
        Sample{"60 rpm", Dimension::angular_velocity, 6.28318530717958647692},
        Sample{"2 rad/s", Dimension::angular_velocity, 2.},
        Sample{"5.25 g", Dimension::mass, 5.25e-3}, Sample{"2 kg", Dimension::mass, 2.},
        Sample{"3 mg", Dimension::mass, 3e-6}, Sample{"1190 kg/m3", Dimension::density, 1190.},
        Sample{"1190 kg/m^3", Dimension::density, 1190.},
        Sample{"1.19 g/cm\u00b3", Dimension::density, 1190.},
        Sample{"300 us", Dimension::time, 3e-4}, Sample{"300 \u00b5s", Dimension::time, 3e-4},
        Sample{"300 \u03bcs", Dimension::time, 3e-4}, Sample{"2 ms", Dimension::time, 2e-3},
        Sample{"4 ns", Dimension::time, 4e-9}, Sample{"1.5 s", Dimension::time, 1.5},
        Sample{"500 J/m2", Dimension::surface_energy, 500.},
        Sample{"0.5 kJ/m^2", Dimension::surface_energy, 500.},
        Sample{"500 N/m", Dimension::surface_energy, 500.},
        Sample{"0.01 s/m", Dimension::slowness, 0.01},
        Sample{"10 us/mm", Dimension::slowness, 0.01}, Sample{"10 ms/m", Dimension::slowness, 0.01},
        Sample{"+0.25", Dimension::number, 0.25}, Sample{"  3e-2 ", Dimension::number, 0.03}));

TEST(Quantity, BareNumberIsMissingItsUnit)
{
  EXPECT_EQ(parse_quantity("30", Dimension::length, Limit::any).problem, "The unit is missing.");
  EXPECT_EQ(parse_quantity("0", Dimension::length, Limit::any).problem, "The unit is missing.");
}

TEST(Quantity, WrongDimensionIsNamed)
{
  EXPECT_EQ(parse_quantity("30 mm", Dimension::time, Limit::any).problem,
            "'mm' is a unit of length.");
  EXPECT_EQ(parse_quantity("720 m/s", Dimension::slowness, Limit::any).problem,
            "'m/s' is a unit of speed.");
}

TEST(Quantity, WrongCapitalsAreCorrected)
{
  EXPECT_EQ(parse_quantity("5 Gpa", Dimension::stress, Limit::any).problem,
            "There is no unit 'Gpa'; did you mean 'GPa'?");
}

TEST(Quantity, PlainNumberHasNoUnit)
{
  EXPECT_EQ(parse_quantity("3 mm", Dimension::number, Limit::any).problem,
            "The value is a plain number without unit, but 'mm' follows.");
}

TEST(Quantity, OnlyFiniteNumbersAreNumbers)
{
  for (const char *text : {"nan mm", "inf mm", "-inf mm", "1e999 mm", "mm", "", "x", "--3 mm"})
    EXPECT_NE(parse_quantity(text, Dimension::length, Limit::any).problem, "") << text;
  EXPECT_NE(parse_quantity("1e308 km/s", Dimension::speed, Limit::any).problem, "");
}

TEST(Quantity, LimitsAreKept)
{
  const auto problem = [](const char *text, const Limit limit)
  { return parse_quantity(text, Dimension::number, limit).problem; };
  EXPECT_EQ(problem("0", Limit::positive), "The value must be above 0.");
  EXPECT_EQ(problem("1e-9", Limit::positive), "");
  EXPECT_EQ(problem("-1e-9", Limit::not_negative), "The value must not be negative.");
  EXPECT_EQ(problem("0", Limit::not_negative), "");
  EXPECT_EQ(problem("1.01", Limit::fraction), "The value must lie between 0 and 1.");
  EXPECT_EQ(problem("1", Limit::fraction), "");
  EXPECT_EQ(problem("-5", Limit::any), "");
}

TEST(Quantity, TupleHasAsManyValuesAsComponents)
{
  const auto size = parse_quantities("200 mm, 10 cm,30mm", Dimension::length, Limit::positive, 3);
  EXPECT_EQ(size.problem, "");
  ASSERT_EQ(size.values.size(), 3U);
  EXPECT_DOUBLE_EQ(size.values[0], 0.2);
  EXPECT_DOUBLE_EQ(size.values[1], 0.1);
  EXPECT_DOUBLE_EQ(size.values[2], 0.03);

  EXPECT_EQ(parse_quantities("1 mm, 2 mm", Dimension::length, Limit::positive, 3).problem,
            "There are 2 values instead of 3.");
  EXPECT_EQ(parse_quantities("1 mm, 2 mm, 3", Dimension::length, Limit::positive, 3).problem,
            "Value 3: The unit is missing.");
  EXPECT_EQ(parse_quantities("1 mm, 2 mm, -3 mm", Dimension::length, Limit::positive, 3).problem,
            "Value 3: The value must be above 0.");
}

TEST(Quantity, DecimalCommaIsExplained)
{
  EXPECT_EQ(parse_quantities("0,3 in", Dimension::length, Limit::any, 1).problem,
            "One value is expected; the decimal mark is a point, not a comma.");
}

TEST(QuantityPattern, ListTakesAnyNumberOfValues)
{
  const auto pattern = QuantityPattern::list(Dimension::time, Limit::positive);
  EXPECT_EQ(pattern.values("1 s"), std::vector<double>{1.});
  EXPECT_EQ(pattern.values("1 s,2 s, 3 s"), (std::vector<double>{1., 2., 3.}));
  EXPECT_EQ(pattern.problem("1 s, 2"), "Value 2: The unit is missing.");
  EXPECT_EQ(pattern.problem("1 s, "), "Value 2: There is no value.");
  EXPECT_EQ(pattern.expected(),
            "one or more values separated by commas, each a time above 0 in ns, us, ms, s, min "
            "or h");
}

TEST(Quantity, MayBeReadWithoutKnowingItsDimension)
{
  const auto speed = parse_free_quantity(" 0.5 km/s");
  ASSERT_TRUE(speed);
  EXPECT_EQ(speed->number, 0.5);
  EXPECT_EQ(speed->unit, "km/s");
  EXPECT_EQ(speed->in_si, 1e3);
  EXPECT_EQ(speed->dimension, Dimension::speed);
  EXPECT_EQ(parse_free_quantity("3")->dimension, Dimension::number);
  for (const char *text : {"", "fast", "3 furlongs", "1 mm, 2 mm", "1e999 m"})
    EXPECT_FALSE(parse_free_quantity(text)) << text;
}

TEST(QuantityPattern, DescribesWhatItMatches)
{
  const QuantityPattern pattern(Dimension::length, Limit::positive);
  EXPECT_EQ(pattern.problem("3 mm"), "");
  EXPECT_EQ(pattern.problem("3"), "The unit is missing.");
  EXPECT_EQ(pattern.expected(), "a length above 0 in um, mm, cm, m or in");
}

TEST(ChoicePattern, SuggestsTheNearestChoice)
{
  const ChoicePattern pattern({"cone", "constant"});
  EXPECT_EQ(pattern.problem("cone"), "");
  EXPECT_EQ(pattern.problem("constnat"), "There is no choice 'constnat'; did you mean 'constant'?");
  EXPECT_EQ(pattern.problem("square"), "There is no choice 'square'.");
  EXPECT_EQ(pattern.expected(), "cone or constant");
}
} // namespace
} // namespace ricochet
