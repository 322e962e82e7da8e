// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs that are stopped and go on leave the results of one that was never stopped.
#include "commands/resume.h"

#include "commands/run.h"
#include "support/scene_text.h"
#include "support/scratch_directory.h"
#include "support/two_plates_text.h"

#include <nlohmann/json.hpp>

namespace ricochet
{
namespace
{
using namespace tests;

const RunOptions quietly{/*force=*/false, /*quiet=*/true};

ParameterFile file_in(const std::filesystem::path &folder, std::vector<std::string> more)
{
  for (const auto *entry : {"Output/Frame interval=6 us", "Output/ParaView files=true",
                            "Output/History interval=1 us", "Time/Final time=24 us"})
    more.emplace_back(entry);
  return two_plates_file(folder.string(), more);
}

/// What all runs of a scene say alike.
std::string said(nlohmann::ordered_json summary)
{
  for (const auto *name : {"core_seconds", "phases", "bond_rate_per_core", "directory", "command"})
    summary.erase(name);
  return summary.dump(2);
}

void expect_the_same_files(const std::filesystem::path &one, const std::filesystem::path &other)
{
  if (rank() != 0)
    return;
  for (const auto *name :
       {"history.csv", "results.pvd", "vtu/projectile_0003.vtu", "vtu/points_0003.000.vtu"})
    EXPECT_TRUE(read_text(one / name) == read_text(other / name)) << name;
  for (const auto *name : {"position", "damage", "pressure", "outline"})
    EXPECT_EQ(read_dataset(one / "section.h5", std::string("frame_0003/") + name).values,
              read_dataset(other / "section.h5", std::string("frame_0003/") + name).values)
        << name;
  EXPECT_EQ(read_dataset(one / "history.h5", "speed").values,
            read_dataset(other / "history.h5", "speed").values);
}

TEST(Resume, FromTheLastCheckpointGivesTheSameResults)
{
  const ScratchDirectory scratch;
  const auto whole = scratch.path() / "whole", broken = scratch.path() / "broken";
  const auto expected = run_scene(MPI_COMM_WORLD, file_in(whole, {}), quietly);
  run_scene(MPI_COMM_WORLD, file_in(broken, {"Output/Checkpoint interval=7 us"}), quietly);
  if (rank() == 0) // at 7, 14 and 21 us; two are kept
  {
    int n = 0;
    for (const auto &entry : std::filesystem::directory_iterator(broken / "checkpoint"))
      n += entry.is_directory() ? 1 : 0;
    EXPECT_EQ(n, 2);
    // As if the run had been killed later.
    std::ofstream(broken / "history.csv", std::ios::app) << "1,2,3\n4,";
    std::filesystem::remove(broken / "results.pvd");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const auto resumed = resume_scene(MPI_COMM_WORLD, broken, {}, quietly);
  expect_the_same_files(whole, broken);
  EXPECT_EQ(said(resumed), said(expected));
}

TEST(Resume, AfterTheWallClockLimitGoesOnToTheEnd)
{
  const ScratchDirectory scratch;
  const auto whole = scratch.path() / "whole", broken = scratch.path() / "broken";
  const auto expected = run_scene(MPI_COMM_WORLD, file_in(whole, {}), quietly);
  const auto stopped =
      run_scene(MPI_COMM_WORLD, file_in(broken, {"Time/Wall-clock limit=1 us"}), quietly);
  EXPECT_EQ(stopped["interrupted"], true);
  EXPECT_TRUE(contains(stopped["reason"], "wall-clock limit")) << stopped["reason"];
  const auto resumed =
      resume_scene(MPI_COMM_WORLD, broken, parse_overrides({"Time/Wall-clock limit=0 s"}), quietly);
  EXPECT_EQ(resumed["interrupted"], false);
  expect_the_same_files(whole, broken);
  EXPECT_EQ(said(resumed), said(expected));
}

TEST(Resume, PassesOverADamagedCheckpoint)
{
  const ScratchDirectory scratch;
  const auto folder = scratch.path() / "results";
  const auto expected =
      run_scene(MPI_COMM_WORLD, file_in(folder, {"Output/Checkpoint interval=7 us"}), quietly);
  std::string newest;
  if (rank() == 0)
  {
    for (const auto &entry : std::filesystem::directory_iterator(folder / "checkpoint"))
      newest = std::max(newest, entry.path().string());
    std::filesystem::resize_file(newest + "/rank_0000.h5", 1000);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  ::testing::internal::CaptureStderr();
  const auto resumed      = resume_scene(MPI_COMM_WORLD, folder, {}, quietly);
  const std::string error = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(contains(error, "missing or cut off"), rank() == 0) << error;
  EXPECT_EQ(said(resumed), said(expected));
}

TEST(Resume, RefusesWhatWouldChangeThePast)
{
  expect_error(
      [&]
      {
        resumed_parameters(
            scene_text, "results",
            parse_overrides({"Impact/Speed=800 m/s", "Contact/Debris friction factor=0.1",
                             "Time/Final time=1 ms"}));
      },
      {"'Impact/Speed', 'Contact/Debris friction factor' cannot change", "Time/Final time"});
  const auto file =
      resumed_parameters(scene_text, "results",
                         parse_overrides({"Time/Final time=1 ms", "Output/Frame interval=1 us",
                                          "Impact/Speed=0.72 mm/us"}));
  EXPECT_EQ(read_scene(file).time.end_time, 1e-3);
  EXPECT_EQ(read_scene(file).output.directory, "results");
}

TEST(Resume, BeforeTheFirstCheckpointBeginsAnew)
{
  const ScratchDirectory scratch;
  const auto whole = scratch.path() / "whole", broken = scratch.path() / "broken";
  const auto expected = run_scene(MPI_COMM_WORLD, file_in(whole, {}), quietly);
  run_scene(MPI_COMM_WORLD, file_in(broken, {}), quietly);
  if (rank() == 0) // as if the run had been killed in between
  {
    std::filesystem::remove(broken / "summary.json");
    std::filesystem::resize_file(broken / "history.csv", 1000);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const auto resumed = resume_scene(MPI_COMM_WORLD, broken, {}, quietly);
  expect_the_same_files(whole, broken);
  EXPECT_EQ(said(resumed), said(expected));
}

TEST(Resume, WithNothingToGoOnWithIsAnError)
{
  const ScratchDirectory scratch;
  EXPECT_TRUE(
      contains(message_of([&] { resume_scene(MPI_COMM_WORLD, scratch.path(), {}, quietly); }),
               "nothing to go on with"));
}
} // namespace
} // namespace ricochet
