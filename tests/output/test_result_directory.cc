// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/folder_lock.h"
#include "ricochet/output/result_directory.h"

#include "support/scratch_directory.h"

#include <unistd.h>

namespace ricochet
{
namespace
{
using namespace tests;
namespace fs = std::filesystem;

void touch(const fs::path &path)
{
  if (rank() == 0)
  {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "content";
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(ResultDirectory, IsCreatedWithItsParents)
{
  const ScratchDirectory scratch;
  const fs::path folder = scratch.path() / "a" / "b";
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/false);
  EXPECT_TRUE(fs::is_directory(folder));
}

TEST(ResultDirectory, WithContentIsRefused)
{
  const ScratchDirectory scratch;
  touch(scratch.path() / "notes.txt");
  const std::string message = message_of(
      [&] { prepare_result_directory(MPI_COMM_WORLD, scratch.path(), /*force=*/false); });
  EXPECT_TRUE(contains(message, scratch.path().string()) && contains(message, "--force"))
      << message;
  EXPECT_TRUE(fs::exists(scratch.path() / "notes.txt"));
}

TEST(ResultDirectory, ForceRemovesResultsAndNothingElse)
{
  const ScratchDirectory scratch;
  const fs::path folder = scratch.path() / "run";
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/false);
  const std::vector<std::string> results = {"history.csv",
                                            "history.h5",
                                            "history.png",
                                            "damage.h5",
                                            "damage.png",
                                            "section.h5",
                                            "section.png",
                                            "section/frame_0012.h5",
                                            "summary.json",
                                            "summary.json.tmp",
                                            "results.pvd",
                                            "used.prm",
                                            "vtu/points_0003.pvtu",
                                            "vtu/points_0003.011.vtu",
                                            "vtu/elements_0003.pvtu",
                                            "vtu/elements_0003.000.vtu",
                                            "vtu/projectile_0003.vtu"};
  const std::vector<std::string> mine    = {"notes.txt",     "history.csv.bak", "my_history.csv",
                                            "vtu/view.pvsm", "vtu/history.csv", "plots/history.csv"};
  for (const auto &names : {results, mine})
    for (const std::string &name : names)
      touch(folder / name);

  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/true);
  for (const std::string &name : results)
    EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const std::string &name : mine)
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "section")); // was empty then
}

TEST(ResultDirectory, ForceDoesNotFollowLinks)
{
  const ScratchDirectory scratch;
  const fs::path folder = scratch.path() / "run";
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/false);
  touch(scratch.path() / "elsewhere" / "points_0000.pvtu");
  if (rank() == 0)
    fs::create_directory_symlink(scratch.path() / "elsewhere", folder / "vtu");
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/true);
  EXPECT_TRUE(fs::exists(scratch.path() / "elsewhere" / "points_0000.pvtu"));
}

TEST(ResultDirectory, ForceRefusesResultsOfOtherOrigin)
{
  const ScratchDirectory scratch;
  touch(scratch.path() / "history.csv");
  const std::string message =
      message_of([&] { prepare_result_directory(MPI_COMM_WORLD, scratch.path(), /*force=*/true); });
  EXPECT_TRUE(contains(message, "history.csv")) << message;
  EXPECT_TRUE(fs::exists(scratch.path() / "history.csv"));
}

TEST(ResultDirectory, NameOfAFileIsRefused)
{
  const ScratchDirectory scratch;
  touch(scratch.path() / "file");
  for (const fs::path &path : {scratch.path() / "file", scratch.path() / "file" / "run"})
    EXPECT_TRUE(contains(
        message_of([&] { prepare_result_directory(MPI_COMM_WORLD, path, /*force=*/true); }),
        "file"));
  EXPECT_EQ(read_text(scratch.path() / "file"), "content");
}

TEST(ResultDirectory, WithoutPermissionIsRefused)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "the administrator may write everywhere";
  const ScratchDirectory scratch;
  if (rank() == 0)
    fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string message = message_of(
      [&] { prepare_result_directory(MPI_COMM_WORLD, scratch.path(), /*force=*/false); });
  EXPECT_TRUE(contains(message, "Permission denied") && contains(message, "may write")) << message;
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0)
    fs::permissions(scratch.path(), fs::perms::owner_all);
}

TEST(ResultDirectory, WithoutSpaceIsRefused)
{
  const ScratchDirectory scratch;
  const FileSizeLimit limit(10);
  const std::string message = message_of(
      [&] { prepare_result_directory(MPI_COMM_WORLD, scratch.path(), /*force=*/false); });
  EXPECT_TRUE(contains(message, scratch.path().string())) << message;
}

TEST(ResultDirectory, BelongsToOneProcessAtATime)
{
  const ScratchDirectory scratch;
  const fs::path folder = scratch.path() / "run";
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/false);
  touch(folder / "history.csv");
  const auto refusal = [&] { return message_of([&] { FolderLock(MPI_COMM_WORLD, folder); }); };
  {
    const FolderLock lock(MPI_COMM_WORLD, folder);
    EXPECT_TRUE(contains(refusal(), "Another ricochet process")) << refusal();
    EXPECT_TRUE(contains(refusal(), folder.string())) << refusal();
    const auto message =
        message_of([&] { prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/true); });
    EXPECT_TRUE(contains(message, "Another ricochet process")) << message;
    EXPECT_TRUE(fs::exists(folder / "history.csv"));
  }
  EXPECT_NO_THROW(FolderLock(MPI_COMM_WORLD, folder));
  prepare_result_directory(MPI_COMM_WORLD, folder, /*force=*/true);
  EXPECT_FALSE(fs::exists(folder / "history.csv"));
  // A folder that is not ours is left alone.
  EXPECT_NO_THROW(FolderLock(MPI_COMM_WORLD, scratch.path()));
  EXPECT_NO_THROW(FolderLock(MPI_COMM_WORLD, scratch.path() / "nowhere"));
}
} // namespace
} // namespace ricochet
