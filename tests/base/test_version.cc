// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/version.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <regex>
#include <string>

namespace ricochet
{
namespace
{
/// What a command prints, without the last line feed; "" if it fails.
std::string output_of(const std::string &command)
{
  std::string text;
  FILE *pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr)
    return "";
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    text += static_cast<char>(c);
  if (pclose(pipe) != 0)
    return "";
  return text.substr(0, text.find_last_not_of('\n') + 1);
}

TEST(Version, NamesReleaseAndCommit)
{
  EXPECT_TRUE(std::regex_match(
      version(), std::regex(R"(\d+\.\d+\.\d+( \(git commit [0-9a-f]{7,}(-dirty)?\))?)")))
      << version();
}

TEST(Version, IsThatOfTheCheckout)
{
  const std::string root   = RICOCHET_SOURCE_DIR;
  const std::string commit = output_of("git -C '" + root + "' rev-parse --short=7 HEAD");
  if (!std::filesystem::exists(root + "/.git") || commit.empty())
    GTEST_SKIP() << "no git checkout, or no git: there is only the release";
  EXPECT_NE(std::string(version()).find("(git commit " + commit), std::string::npos) << version();
}
} // namespace
} // namespace ricochet
