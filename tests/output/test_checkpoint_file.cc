// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/checkpoint_file.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/state_size.h"
#include "support/scratch_directory.h"

#include <numeric>

namespace ricochet::tests
{
namespace
{
/// State of every kind, spread over the ranks.
struct State
{
  double number = 0.;
  Vector3 vector{0., 0., 0.};
  std::string text;
  std::vector<float> list;
  // Ten planes of three numbers each, with a ghost plane on either side.
  StateArchive::PlaneShare share{};
  std::vector<double> planes;
  std::vector<std::int64_t> keys;
  std::vector<double> rows; // two per key

  explicit State(const MPI_Comm communicator)
  {
    const int n = size_of(communicator), r = rank_in(communicator);
    share = {10 * r / n, 10 * (r + 1) / n, 10 * r / n - 1, 10 * (r + 1) / n + 1, 10};
    planes.assign(3 * (share.last_local - share.first_local), -1.);
    for (std::int64_t key = 100 + r; key < 120; key += n)
      keys.push_back(key);
    rows.assign(2 * keys.size(), 0.);
  }

  void fill()
  {
    number = 1. / 3.;
    vector = {1., 2., 3.};
    text   = "two\nlines";
    list   = {1.5f, 2.5f};
    for (std::size_t i = 0; i < planes.size(); ++i)
      planes[i] = 3. * share.first_local + static_cast<double>(i);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      rows[2 * i]     = static_cast<double>(keys[i]);
      rows[2 * i + 1] = std::sqrt(static_cast<double>(keys[i]));
    }
  }

  void exchange(StateArchive &archive)
  {
    archive.common("number", number);
    const StateArchive::Group group(archive, "a group");
    archive.common("vector", vector);
    archive.common("text", text);
    archive.common("list", list);
    archive.planes("planes", planes.data(), 3 * sizeof(double), share);
    archive.rows("rows", keys, rows, 2);
  }
};

void save(const std::filesystem::path &path)
{
  State state(MPI_COMM_WORLD);
  state.fill();
  CheckpointWriter archive(MPI_COMM_WORLD);
  EXPECT_FALSE(archive.is_restoring());
  state.exchange(archive);
  archive.save(path);
}

void expect_restored(const State &state)
{
  EXPECT_EQ(state.number, 1. / 3.);
  EXPECT_EQ(state.vector, Vector3(1., 2., 3.));
  EXPECT_EQ(state.text, "two\nlines");
  EXPECT_EQ(state.list, (std::vector<float>{1.5f, 2.5f}));
  for (int plane = state.share.first_local; plane < state.share.last_local; ++plane)
    for (int i = 0; i < 3; ++i) // beyond the body nothing is kept
      EXPECT_EQ(state.planes[3 * (plane - state.share.first_local) + i],
                plane < 0 || plane >= 10 ? -1. : 3. * plane + i);
  for (std::size_t i = 0; i < state.keys.size(); ++i)
    EXPECT_EQ(state.rows[2 * i + 1], std::sqrt(static_cast<double>(state.keys[i])));
}

TEST(CheckpointFile, GivesBackWhatWasPutIntoIt)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "checkpoint" / "step_1";
  save(path);
  CheckpointReader archive(MPI_COMM_WORLD, path);
  EXPECT_TRUE(archive.is_restoring());
  State state(MPI_COMM_WORLD);
  state.exchange(archive);
  expect_restored(state);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".tmp"));
}

TEST(CheckpointFile, GivesBackAllOnOneRank)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "step_1";
  save(path);
  CheckpointReader archive(MPI_COMM_SELF, path);
  State state(MPI_COMM_SELF);
  state.exchange(archive);
  expect_restored(state);
}

TEST(CheckpointFile, TakesWhatStateSizeSays)
{
  State state(MPI_COMM_WORLD);
  state.fill();
  StateSize size(MPI_COMM_WORLD);
  state.exchange(size);
  // A number and a vector, a text, two floats; planes, rows with their keys.
  EXPECT_EQ(size.bytes(), 8 + 24 + 9 + 8 + 10 * 3 * 8 + 20 * (8 + 2 * 8));
}

TEST(CheckpointFile, OnAFullDiskThrowsAndKeepsTheOneBefore)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "step_1";
  save(path);
  {
    const FileSizeLimit limit(4096);
    EXPECT_FALSE(message_of([&] { save(path); }).empty());
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".tmp"));
  CheckpointReader archive(MPI_COMM_WORLD, path);
  State state(MPI_COMM_WORLD);
  state.exchange(archive);
  expect_restored(state);
}

TEST(CheckpointFile, WithAnyByteOfItsStateChangedIsRefused)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "step_1";
  save(path);
  std::string bytes;
  const auto file = path / "rank_0000.h5";
  if (rank() == 0)
  {
    bytes         = read_text(file);
    const auto at = bytes.find("two\nlines");
    ASSERT_NE(at, std::string::npos);
    bytes[at] = 'T';
    std::ofstream(file, std::ios::binary) << bytes;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const auto message = message_of([&] { CheckpointReader(MPI_COMM_WORLD, path); });
  EXPECT_TRUE(contains(message, "a group/text") && contains(message, "damaged")) << message;
}

TEST(CheckpointFile, CutOffOrMissingIsRefused)
{
  const ScratchDirectory folder;
  const auto path    = folder.path() / "step_1";
  const auto message = [&] { return message_of([&] { CheckpointReader(MPI_COMM_WORLD, path); }); };
  EXPECT_TRUE(contains(message(), "rank_0000.h5 is missing or cut off"));
  save(path);
  const auto last = path / ("rank_000" + std::to_string(n_ranks() - 1) + ".h5");
  if (rank() == 0)
    std::filesystem::resize_file(last, std::filesystem::file_size(last) / 2);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(contains(message(), last.filename().string() + " is missing or cut off"));
}

TEST(CheckpointFile, OfAnotherSceneIsRefused)
{
  const ScratchDirectory folder;
  const auto path = folder.path() / "step_1";
  save(path);
  CheckpointReader archive(MPI_COMM_WORLD, path);
  std::array<double, 2> two{};
  EXPECT_TRUE(contains(message_of([&] { archive.common("number", two); }), "does not fit"));
  double other = 0.;
  EXPECT_TRUE(contains(message_of([&] { archive.common("other", other); }), "no 'other'"));
  std::vector<std::int64_t> keys{7};
  std::vector<double> row(2);
  EXPECT_TRUE(
      contains(message_of([&] { archive.rows("a group/rows", keys, row, 2); }), "does not fit"));
}
} // namespace
} // namespace ricochet::tests
