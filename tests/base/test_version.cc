// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/version.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

namespace ricochet
{
namespace
{
TEST(Version, NamesReleaseAndCommit)
{
  EXPECT_TRUE(std::regex_match(
      version(), std::regex(R"(\d+\.\d+\.\d+( \(git commit [0-9a-f]{7,}(-dirty)?\))?)")))
      << version();
}

TEST(Version, IsACommitOfTheCheckout)
{
  // Not necessarily the last one: nobody has to build between a commit and a test.
  const std::string root = RICOCHET_SOURCE_DIR;
  const std::string git  = "git -C '" + root + "' ";
  if (!std::filesystem::exists(root + "/.git") ||
      std::system((git + "rev-parse --quiet HEAD > /dev/null 2>&1").c_str()) != 0)
    GTEST_SKIP() << "no git checkout, or no git: there is only the release";
  std::smatch match;
  const std::string text = version();
  ASSERT_TRUE(std::regex_search(text, match, std::regex("git commit ([0-9a-f]+)"))) << text;
  EXPECT_EQ(std::system((git + "merge-base --is-ancestor " + match[1].str() + " HEAD").c_str()), 0)
      << text;
}
} // namespace
} // namespace ricochet
