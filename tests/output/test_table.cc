// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ricochet
{
namespace
{
Table three_rows()
{
  Table table({"case", "speed", "steps", "status"});
  table.add({"a", 123.456789012, 7, "ok"});
  table.add({"longer", nullptr, 123456, "failed: \"x\", y"});
  table.add({"b", std::nan(""), nullptr, nullptr});
  return table;
}

TEST(Table, CsvHasAllDigitsAndQuotesWhatNeedsIt)
{
  EXPECT_EQ(three_rows().csv(), "case,speed,steps,status\n"
                                "a,123.456789012,7,ok\n"
                                "longer,-,123456,\"failed: \"\"x\"\", y\"\n"
                                "b,null,-,-\n");
}

TEST(Table, TextIsAlignedWithFourDigits)
{
  EXPECT_EQ(three_rows().text(), "case    speed   steps  status\n"
                                 "a       123.5       7  ok\n"
                                 "longer      -  123456  failed: \"x\", y\n"
                                 "b         nan       -  -\n");
}

TEST(Table, WithoutRowsIsItsHeader)
{
  const Table table({"a", "b"});
  EXPECT_EQ(table.csv(), "a,b\n");
  EXPECT_EQ(table.text(), "a  b\n");
}
} // namespace
} // namespace ricochet
