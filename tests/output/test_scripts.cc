// SPDX-License-Identifier: LGPL-2.1-or-later
#include "output/scripts.h"

#include "support/environment.h"
#include "support/scratch_directory.h"

#include <algorithm>

namespace ricochet
{
namespace
{
using namespace tests;
namespace fs = std::filesystem;

TEST(Scripts, LieBesideTheFolderOfTheProgramAlsoWhenBothAreMoved)
{
  const ScratchDirectory scratch;
  const fs::path before = scratch.path() / "usr", after = scratch.path() / "elsewhere";
  fs::create_directories(before / "bin");
  fs::create_directories(before / "share" / "ricochet" / "scripts");
  EXPECT_EQ(script_folder(before / "bin" / "ricochet"), before / "share" / "ricochet" / "scripts");
  fs::rename(before, after);
  EXPECT_EQ(script_folder(after / "bin" / "ricochet"), after / "share" / "ricochet" / "scripts");
}

TEST(Scripts, OfABuildFolderAreThoseOfTheSource)
{
  for (const char *program : {"ricochet", "source/ricochet", "tests/app_tests"})
  {
    const fs::path folder = script_folder(fs::path(RICOCHET_BINARY_DIR) / program);
    EXPECT_TRUE(fs::equivalent(folder, fs::path(RICOCHET_SOURCE_DIR) / "scripts")) << program;
  }
}

TEST(Scripts, TheEnvironmentVariableWins)
{
  const Variable variable("RICOCHET_SCRIPT_DIR", "/some/where");
  EXPECT_EQ(script_folder(fs::path(RICOCHET_BINARY_DIR) / "source" / "ricochet"), "/some/where");
}

TEST(Scripts, AnInstallationWithoutThemNamesThePlaceWhereTheyShouldBe)
{
  EXPECT_EQ(script_folder("/no/where/bin/ricochet"), "/no/where/share/ricochet/scripts");
}

TEST(Programs, GetTheirArgumentsAsTheyAre)
{
  const std::vector<std::string> arguments{"%s|", "a b", "$(echo bad)", "", "'\"*"};
  const auto result = run_program("printf", arguments);
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.text, "a b|$(echo bad)||'\"*|");
}

TEST(Programs, TellTheirExitStatusAndWhyTheyDidNotStart)
{
  EXPECT_EQ(run_program("sh", {"-c", "echo words >&2; exit 7"}).status, 7);
  EXPECT_EQ(run_program("sh", {"-c", "echo words >&2; exit 7"}).text, "words\n");
  EXPECT_EQ(run_program("sh", {"-c", "kill -9 $$"}).status, ProgramResult::not_ended);
  const auto none = run_program("there_is_no_such_program", {});
  EXPECT_EQ(none.status, -1);
  EXPECT_TRUE(contains(none.text, "No such file")) << none.text;
}

TEST(Programs, AreEndedIfTheyDoNotEnd)
{
  const auto start  = std::chrono::steady_clock::now();
  const auto result = run_program("sh", {"-c", "exec sleep 60"}, std::chrono::seconds(1));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(result.status, ProgramResult::not_ended);
  EXPECT_TRUE(contains(result.text, "after 1 s")) << result.text;
}

TEST(Programs, DoNotSeeTheMarksOfAnMpiProcess)
{
  const Variable ours("RICOCHET_TEST_MARK", "seen"), mpi("OMPI_COMM_WORLD_SIZE", "3");
  const auto result = run_program("env", {});
  EXPECT_TRUE(contains(result.text, "RICOCHET_TEST_MARK=seen"));
  EXPECT_FALSE(contains(result.text, "OMPI_")) << result.text;
}
} // namespace
} // namespace ricochet
