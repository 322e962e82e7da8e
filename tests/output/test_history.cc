// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/history.h"
#include "ricochet/output/summary.h"

#include "support/scratch_directory.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;

const std::vector<History::Column> columns = {
    {"time", "us"}, {"force normal", "kN"}, {"residual relative", "-"}};

std::vector<double> row(const int i)
{
  return {0.5 * i, 123.456789 * std::sin(i), 1e-7 / (i + 3.)};
}

TEST(History, WritesNamesUnitsAndEveryRowAtOnce)
{
  const ScratchDirectory scratch;
  History history(MPI_COMM_WORLD, scratch.path(), columns);
  for (int i = 0; i < 4; ++i)
  {
    history.append(row(i));
    if (rank() != 0)
      continue;
    // Not closed yet: what a broken run leaves.
    const std::vector<std::string> lines = split(read_text(scratch.path() / "history.csv"), '\n');
    ASSERT_EQ(lines.size(), i + 2u);
    EXPECT_EQ(lines[0], "time [us],force normal [kN],residual relative [-]");
    const std::vector<std::string> numbers = split(lines.back(), ',');
    ASSERT_EQ(numbers.size(), 3u);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(std::stod(numbers[c]), row(i)[c], 1e-9 * std::abs(row(i)[c]));
  }
}

TEST(History, Hdf5EqualsTheRows)
{
  const ScratchDirectory scratch;
  History history(MPI_COMM_WORLD, scratch.path(), columns);
  const int n = 2500; // long enough to be compressed
  for (int i = 0; i < n; ++i)
    history.append(row(i));
  history.close();
  history.close();
  if (rank() != 0)
    return;
  for (int c = 0; c < 3; ++c)
  {
    const Dataset dataset = read_dataset(scratch.path() / "history.h5", columns[c].name);
    EXPECT_EQ(dataset.unit, columns[c].unit);
    ASSERT_EQ(dataset.values.size(), static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
      ASSERT_EQ(dataset.values[i], row(i)[c]);
  }
}

TEST(History, WithoutRowsIsStillReadable)
{
  const ScratchDirectory scratch;
  History history(MPI_COMM_WORLD, scratch.path(), columns);
  history.close();
  if (rank() == 0)
  {
    EXPECT_EQ(split(read_text(scratch.path() / "history.csv"), '\n').size(), 1u);
    EXPECT_TRUE(read_dataset(scratch.path() / "history.h5", "time").values.empty());
  }
}

TEST(History, MissingFolderIsAnErrorOnAllRanks)
{
  const ScratchDirectory scratch;
  const std::string message =
      message_of([&] { History history(MPI_COMM_WORLD, scratch.path() / "missing", columns); });
  EXPECT_TRUE(contains(message, "history.csv") && contains(message, "No such file")) << message;
}

TEST(History, FullDiskKeepsWholeLines)
{
  const ScratchDirectory scratch;
  History history(MPI_COMM_WORLD, scratch.path(), columns);
  int n_written = 0;
  std::string message;
  {
    const FileSizeLimit limit(500);
    message = message_of(
        [&]
        {
          for (; n_written < 100; ++n_written)
            history.append(row(n_written));
        });
  }
  EXPECT_TRUE(contains(message, "history.csv") && contains(message, "too large")) << message;
  EXPECT_GT(n_written, 5);
  if (rank() != 0)
    return;
  const std::string text = read_text(scratch.path() / "history.csv");
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(split(text, '\n').size(), n_written + 1u);
}

TEST(History, DeviceWithoutSpaceNamesTheReason)
{
  const ScratchDirectory scratch;
  if (rank() == 0)
    std::filesystem::create_symlink("/dev/full", scratch.path() / "history.csv");
  const std::string message =
      message_of([&] { History history(MPI_COMM_WORLD, scratch.path(), columns); });
  EXPECT_TRUE(contains(message, "No space left") && contains(message, "Free some space"))
      << message;
}

TEST(Summary, KeepsOrderAndReplacesTheOlderFile)
{
  const ScratchDirectory scratch;
  nlohmann::ordered_json summary;
  summary["outcome"]        = "stuck";
  summary["exit_speed_m_s"] = std::nan("");
  write_summary(MPI_COMM_WORLD, scratch.path(), summary);
  summary["outcome"] = "ricochet";
  write_summary(MPI_COMM_WORLD, scratch.path(), summary);
  if (rank() != 0)
    return;
  const auto read = nlohmann::ordered_json::parse(read_text(scratch.path() / "summary.json"));
  EXPECT_EQ(read.begin().key(), "outcome");
  EXPECT_EQ(read["outcome"], "ricochet");
  EXPECT_TRUE(read["exit_speed_m_s"].is_null());
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "summary.json.tmp"));
}

TEST(Summary, FullDiskKeepsTheOlderFile)
{
  const ScratchDirectory scratch;
  write_summary(MPI_COMM_WORLD, scratch.path(), {{"outcome", "first"}});
  const nlohmann::ordered_json longer = {{"outcome", std::string(5000, 'x')}};
  {
    const FileSizeLimit limit(1000);
    const std::string message =
        message_of([&] { write_summary(MPI_COMM_WORLD, scratch.path(), longer); });
    EXPECT_TRUE(contains(message, "summary.json")) << message;
  }
  if (rank() != 0)
    return;
  EXPECT_EQ(nlohmann::json::parse(read_text(scratch.path() / "summary.json"))["outcome"], "first");
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "summary.json.tmp"));
}
} // namespace
} // namespace ricochet
