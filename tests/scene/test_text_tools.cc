// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/text_tools.h"

#include <gtest/gtest.h>

namespace ricochet
{
namespace
{
TEST(TextTools, BlanksAreSqueezed)
{
  EXPECT_EQ(squeezed("  a \t b\r\n"), "a b");
  EXPECT_EQ(squeezed(" \t"), "");
}

TEST(TextTools, PartsKeepTheirPlaces)
{
  EXPECT_EQ(split(" a , b,,c ", ','), (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_EQ(split("a", ','), std::vector<std::string>{"a"});
  EXPECT_EQ(split("", ','), std::vector<std::string>{""});
}

TEST(TextTools, ListsAreJoinedLikeSentences)
{
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"a"}, " or "), "a");
  EXPECT_EQ(joined({"a", "b"}, " or "), "a or b");
  EXPECT_EQ(joined({"a", "b", "c"}, " or "), "a, b or c");
  EXPECT_EQ(joined({"a", "b", "c"}), "a, b, c");
}

TEST(TextTools, PathsOfEntriesNameTheirSection)
{
  EXPECT_EQ(entry_path("Plate 1", "Gap"), "Plate 1/Gap");
  EXPECT_EQ(entry_path("", "Title"), "Title");
}

TEST(TextTools, NearestWordIsFoundIfItIsNear)
{
  EXPECT_EQ(nearest("Sped", {"Speed", "Size"}), "Speed");
  EXPECT_EQ(nearest("sPEED", {"Speed"}), "Speed"); // capitals do not count
  EXPECT_EQ(nearest("Spede", {"Speed"}), "Speed"); // a swap is one change
  EXPECT_EQ(nearest("Mass", {"Speed", "Size"}), "");
  EXPECT_EQ(guess("Sped", {"Speed"}), "; did you mean 'Speed'?");
  EXPECT_EQ(guess("Mass", {"Speed"}), ".");
}

TEST(TextTools, QuotedTextIsShortAndPlain)
{
  EXPECT_EQ(in_quotes("a\tb\n"), "'a?b?'");
  EXPECT_EQ(in_quotes(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
}

TEST(TextTools, NumbersHaveSixDigits)
{
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(2e9), "2e+09");
  EXPECT_EQ(number_text(1. / 3.), "0.333333");
}
} // namespace
} // namespace ricochet
