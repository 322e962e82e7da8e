// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/checked_file.h"

#include "support/scratch_directory.h"

namespace ricochet
{
namespace
{
using namespace tests;
namespace fs = std::filesystem;

TEST(CheckedFile, OlderContentSurvivesAFullDisk)
{
  const ScratchDirectory scratch;
  const fs::path path = scratch.path() / "file";
  write_file(path, "old");
  {
    const FileSizeLimit limit(100);
    const std::string message = message_of([&] { write_file(path, std::string(1000, 'x')); });
    EXPECT_TRUE(contains(message, path.string()) && contains(message, "ulimit -f")) << message;
  }
  EXPECT_EQ(read_text(path), "old");
  EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
  write_file(path, std::string("with\0zero", 9));
  EXPECT_EQ(read_text(path), std::string("with\0zero", 9));
}

TEST(CheckedFile, SaysWhichFolderIsMissing)
{
  const ScratchDirectory scratch;
  const std::string message = message_of([&] { write_file(scratch.path() / "no" / "file", ""); });
  EXPECT_TRUE(contains(message, "/no/file") && contains(message, "Check that the folder exists"))
      << message;
}

TEST(AppendedFile, KeepsWholePiecesOnAFullDisk)
{
  const ScratchDirectory scratch;
  const fs::path path = scratch.path() / "lines";
  AppendedFile file(path);
  file.append("first\n");
  {
    const FileSizeLimit limit(10);
    EXPECT_TRUE(contains(message_of([&] { file.append("second, too long\n"); }), "lines"));
  }
  EXPECT_EQ(read_text(path), "first\n");
  file.append("third\n");
  file.close();
  file.close();
  EXPECT_EQ(read_text(path), "first\nthird\n");
}

TEST(AppendedFile, StartsEmpty)
{
  const ScratchDirectory scratch;
  write_file(scratch.path() / "lines", "of an earlier run\n");
  const AppendedFile file(scratch.path() / "lines");
  EXPECT_EQ(read_text(scratch.path() / "lines"), "");
}

TEST(MakeDirectory, RefusesAFileOfThatName)
{
  const ScratchDirectory scratch;
  make_directory(scratch.path() / "a" / "b");
  make_directory(scratch.path() / "a" / "b"); // exists
  EXPECT_TRUE(fs::is_directory(scratch.path() / "a" / "b"));
  write_file(scratch.path() / "file", "");
  EXPECT_TRUE(contains(message_of([&] { make_directory(scratch.path() / "file"); }), "file"));
  EXPECT_TRUE(contains(message_of([&] { make_directory(scratch.path() / "file" / "b"); }), "file"));
}
} // namespace
} // namespace ricochet
