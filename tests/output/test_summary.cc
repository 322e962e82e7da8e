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
    EXPECT_EQ(read_text(scratch.path() / "summary.json"), "{\n  \"z\": 0,\n  \"a\": 0.1\n}\n");
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
}
} // namespace
} // namespace ricochet
