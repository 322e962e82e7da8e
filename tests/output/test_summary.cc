// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/summary.h"

#include "support/scratch_directory.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace ricochet
{
namespace
{
using namespace tests;
using Json = nlohmann::ordered_json;

TEST(Summary, IsOfRankZeroInItsOrderAndReplacesAnOlderOne)
{
  const ScratchDirectory scratch;
  write_summary(MPI_COMM_WORLD, scratch.path(), {{"old", 1}});
  write_summary(MPI_COMM_WORLD, scratch.path(), {{"z", rank()}, {"a", 0.1}});
  if (rank() == 0)
  {
    const std::string text = read_text(scratch.path() / "summary.json");
    EXPECT_TRUE(contains(text, "{\n  \"z\": 0,\n  \"a\": 0.1,\n  \"checksum\": \"")) << text;
    EXPECT_FALSE(contains(text, "old"));
  }
}

TEST(Summary, StaysReadableWhateverARunPutsIntoIt)
{
  const ScratchDirectory scratch;
  write_summary(MPI_COMM_WORLD, scratch.path(),
                {{"speed", std::nan("")}, {"title", "Sch\xFC\x73se"}}); // Latin-1, not UTF-8
  if (rank() != 0)
    return;
  const auto read = Json::parse(read_text(scratch.path() / "summary.json"));
  EXPECT_TRUE(read["speed"].is_null());
  EXPECT_EQ(read["title"], "Sch\uFFFDsse");
  EXPECT_TRUE(is_untouched(read));
}

TEST(Summary, ThatHasBeenChangedIsFound)
{
  const ScratchDirectory scratch;
  write_summary(MPI_COMM_WORLD, scratch.path(), {{"speed", 0.1}, {"title", "Test"}});
  if (rank() != 0)
    return;
  auto read = Json::parse(read_text(scratch.path() / "summary.json"));
  EXPECT_TRUE(is_untouched(read));
  read["speed"] = 0.2;
  EXPECT_FALSE(is_untouched(read));
  EXPECT_FALSE(is_untouched(Json::object()));
}
} // namespace
} // namespace ricochet
