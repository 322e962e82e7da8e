// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/study.h"

#include "commands/study_case.h"

#include "ricochet/base/version.h"
#include "support/scene_text.h"
#include "support/scratch_directory.h"
#include "support/two_plates_text.h"

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <thread>
#include <unistd.h>

namespace ricochet
{
namespace
{
using namespace tests;
namespace fs = std::filesystem;

/// A study of two speeds over 1 us in the folder, the second of which may be impossible.
std::string write_study(const fs::path &folder, const std::string &second_speed,
                        const std::string &final_time = "1 us")
{
  if (rank() == 0)
  {
    std::ofstream(folder / "base.prm") << two_plates_text;
    std::ofstream(folder / "study.prm")
        << "subsection Study\n  set Title = Two speeds\n  set Scenes = base.prm\n"
        << "  set Axis 1 = Impact/Speed: 300 m/s | " << second_speed << "\n"
        << "  set Columns = outcome, exit_speed_m_s, on_elements_us\n"
        << "  set Settings = Time/Final time: " << final_time << "\n"
        << "  set Pictures = false\n  set Report = false\n  set Output directory = "
        << (folder / "results").string() << "\nend\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return (folder / "study.prm").string();
}

StudyOptions quiet()
{
  StudyOptions options;
  options.quiet = true;
  return options;
}

TEST(Study, TableHasARowPerCaseAndIsNotMadeTwice)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(run_study(MPI_COMM_WORLD, path, quiet()).n_failed, 0);
  EXPECT_TRUE(contains(message_of([&] { run_study(MPI_COMM_WORLD, path, quiet()); }), "--resume"));
  auto resume   = quiet();
  resume.resume = true;
  EXPECT_EQ(run_study(MPI_COMM_WORLD, path, resume).n_failed, 0);
  const std::string text = ::testing::internal::GetCapturedStdout();
  if (rank() != 0)
    return;
  const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "case,speed_m_s,outcome,exit_speed_m_s,on_elements_us,status");
  EXPECT_TRUE(contains(lines[1], "base__speed_300_m_s,300.0,undecided,")) << lines[1];
  EXPECT_TRUE(contains(lines[2], ",-,finished before")) << lines[2];
  EXPECT_TRUE(contains(text, "[2/2] base__speed_400_m_s: finished before")) << text;
}

TEST(Study, UnknownColumnsAreRefusedBeforeTheFirstRun)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  if (rank() == 0)
    std::ofstream(scratch.path() / "study.prm")
        << "subsection Study\n  set Scenes = base.prm\n  set Columns = outcom\n"
        << "  set Output directory = " << (scratch.path() / "results").string() << "\nend\n";
  MPI_Barrier(MPI_COMM_WORLD);
  expect_error([&] { run_study(MPI_COMM_WORLD, path, quiet()); },
               {"study.prm:3", "did you mean 'outcome'?"});
  EXPECT_FALSE(fs::exists(scratch.path() / "results"));
}

TEST(Study, DataOfOthersStandInTheTable)
{
  const ScratchDirectory scratch;
  const auto path      = write_study(scratch.path(), "400 m/s");
  const auto with_data = [&](const std::string &file)
  {
    MPI_Barrier(MPI_COMM_WORLD); // nobody still reads it
    if (rank() == 0)
      std::ofstream(scratch.path() / "study.prm")
          << "subsection Study\n  set Scenes = base.prm\n  set Columns = outcome\n"
          << "  set Settings = Time/Final time: 1 us; Output/History interval: 0.1 us\n"
          << "  set Reference data = " << file << "\n  set Pictures = false\n  set Report = false\n"
          << "  set Output directory = " << (scratch.path() / "results").string() << "\nend\n";
    MPI_Barrier(MPI_COMM_WORLD);
  };
  with_data("nowhere.csv");
  expect_error<FileError>([&] { run_study(MPI_COMM_WORLD, path, quiet()); }, {"nowhere.csv"});
  if (rank() == 0) // nothing is touched before the second time
    std::ofstream(scratch.path() / "exp.csv") << "time [us],path [mm]\n0.5,0.1\n9,5\n";
  with_data("exp.csv");
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(run_study(MPI_COMM_WORLD, path, quiet()).n_failed, 0);
  ::testing::internal::GetCapturedStdout();
  if (rank() != 0)
    return;
  const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
  EXPECT_EQ(lines.at(0), "case,outcome,reference_rmse_path_mm,reference_error_path_0.5_us_percent,"
                         "reference_error_path_9_us_percent,status");
  const auto cells = split(lines.at(1), ',');
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_GT(std::stod(cells[2]), 0.);
  EXPECT_NEAR(std::stod(cells[3]), 1e3 * std::stod(cells[2]), 1e-6); // of 0.1 mm
  EXPECT_EQ(cells[4], "-");
}

TEST(Study, RecordSaysWhatEachCaseIs)
{
  const ScratchDirectory scratch;
  ::testing::internal::CaptureStdout();
  run_study(MPI_COMM_WORLD, write_study(scratch.path(), "400 m/s"), quiet());
  ::testing::internal::GetCapturedStdout();
  if (rank() != 0)
    return;
  const auto record =
      nlohmann::ordered_json::parse(read_text(scratch.path() / "results" / "study.json"));
  EXPECT_EQ(record["title"], "Two speeds");
  EXPECT_EQ(record["axes"][0]["label"], "speed");
  EXPECT_EQ(record["axes"][0]["unit"], "m/s");
  EXPECT_EQ(record["cases"][1]["label"], "400 m/s");
  EXPECT_EQ(record["cases"][1]["axes"][0], 400.);
  EXPECT_EQ(record["cases"][1]["status"], "ok");
}

TEST(Study, EndsWithAReportOfItAndOfItsCases)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  if (rank() == 0)
  {
    std::string text = read_text(path);
    for (const std::string off = "set Report = false"; contains(text, off);)
      text.replace(text.find(off), off.size(), "");
    text.replace(text.find("set Settings = "), 15, "set Settings = Output/Report: true; ");
    std::ofstream(path) << text;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  ::testing::internal::CaptureStdout();
  run_study(MPI_COMM_WORLD, path, quiet());
  const std::string text = ::testing::internal::GetCapturedStdout();
  if (rank() != 0)
    return;
  EXPECT_TRUE(contains(text, "Report: ")) << text;
  const auto results = scratch.path() / "results";
  EXPECT_TRUE(contains(read_text(results / "report.html"), "Two speeds"));
  EXPECT_TRUE(contains(read_text(results / "base__speed_400_m_s" / "report.html"), "subsection"));
}

TEST(Study, AChangedCaseIsRunAgain)
{
  const ScratchDirectory scratch;
  ::testing::internal::CaptureStdout();
  run_study(MPI_COMM_WORLD, write_study(scratch.path(), "400 m/s"), quiet());
  auto resume        = quiet();
  resume.resume      = true;
  const auto changed = write_study(scratch.path(), "410 m/s");
  EXPECT_EQ(run_study(MPI_COMM_WORLD, changed, resume).n_failed, 0);
  ::testing::internal::GetCapturedStdout();
  if (rank() != 0)
    return;
  const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
  EXPECT_TRUE(contains(lines.at(1), ",finished before")) << lines[1];
  EXPECT_TRUE(contains(lines.at(2), "speed_410_m_s") && contains(lines[2], ",ok")) << lines[2];
}

TEST(Study, SummariesThatAreNotItsOwnAreNotTrusted)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  ::testing::internal::CaptureStdout();
  run_study(MPI_COMM_WORLD, path, quiet());
  ::testing::internal::GetCapturedStdout();
  auto resume            = quiet();
  resume.resume          = true;
  const auto summary     = scratch.path() / "results" / "base__speed_300_m_s" / "summary.json";
  const std::string good = read_text(summary);
  using Change           = std::array<std::string, 3>;
  for (const auto &[from, to, reason] :
       {Change{"\"failed\": false", "\"failed\": \"no\"", "has been changed"},
        Change{"\"outcome\": \"undecided\"", "\"outcome\": \"perforate\"", "has been changed"},
        Change{version(), "0.0.1", "made by another version, \"0.0.1"},
        Change{"{", "", "cannot be read"}})
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank() == 0)
    {
      std::string text = good;
      text.replace(text.find(from), from.size(), to);
      std::ofstream(summary) << text;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(run_study(MPI_COMM_WORLD, path, resume).n_failed, 0);
    const std::string text = ::testing::internal::GetCapturedStdout();
    const bool is_right    = contains(text, "300_m_s: run again, ") && contains(text, reason) &&
                          contains(text, "400_m_s: finished before");
    EXPECT_EQ(is_right, rank() == 0) << reason << " in " << text;
  }
}

TEST(Study, CasesRunOneByOneAndAreCollected)
{
  const ScratchDirectory scratch;
  const auto path     = write_study(scratch.path(), "400 m/s");
  const auto run_with = [&](const bool list, const bool collect, const std::string &only)
  {
    auto options    = quiet();
    options.list    = list;
    options.collect = collect;
    options.only    = only;
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(run_study(MPI_COMM_WORLD, path, options).n_failed, 0);
    return ::testing::internal::GetCapturedStdout();
  };
  run_with(false, false, "2");
  if (rank() == 0)
  {
    EXPECT_FALSE(fs::exists(scratch.path() / "results" / "study.csv"));
  }
  const auto listed = run_with(true, false, "");
  run_with(false, true, "");
  EXPECT_TRUE(contains(message_of([&] { run_study(MPI_COMM_WORLD, path, quiet()); }), "--resume"));
  auto wrong = quiet();
  wrong.only = "3";
  expect_error([&] { run_study(MPI_COMM_WORLD, path, wrong); }, {"--case 3", "2 cases", "--list"});
  if (rank() != 0)
    return;
  EXPECT_TRUE(contains(listed, "1  base__speed_300_m_s  (300 m/s)  to run\n")) << listed;
  EXPECT_TRUE(contains(listed, "2  base__speed_400_m_s  (400 m/s)  finished\n")) << listed;
  const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
  EXPECT_TRUE(contains(lines.at(1), ",missing")) << lines[1];
  EXPECT_TRUE(contains(lines.at(2), ",finished before")) << lines[2];
}

TEST(Study, PricesAreToldAndNothingIsStarted)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  auto options    = quiet();
  options.dry_run = true;
  ::testing::internal::CaptureStdout();
  run_study(MPI_COMM_WORLD, path, options);
  const auto text = ::testing::internal::GetCapturedStdout();
  EXPECT_FALSE(fs::exists(scratch.path() / "results"));
  if (rank() != 0)
    return;
  EXPECT_TRUE(contains(text, "core-seconds") && contains(text, "memory MB")) << text;
  EXPECT_TRUE(contains(text, "400 m/s  ") && contains(text, "\n2 to run: ")) << text;
  EXPECT_TRUE(contains(text, "Nothing was started.")) << text;
}

TEST(Study, SideBySideIsForAProcessAlone)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  auto options    = quiet();
  options.n_jobs  = 2;
  if (n_ranks() > 1)
    expect_error([&] { run_study(MPI_COMM_WORLD, path, options); }, {"--jobs 2", "mpirun"});
}

TEST(Study, SearchesForALimitByCasesOfItsOwn)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  if (rank() == 0)
    std::ofstream(path)
        << "subsection Study\n  set Scenes = base.prm\n  set Columns = outcome\n"
        << "  set Find limit = Impact/Speed between other and stuck\n"
        << "  set Limit range = 300 m/s to 500 m/s\n  set Limit tolerance = 50 m/s\n"
        << "  set Settings = Time/Final time: 1 us\n  set Pictures = false\n"
        << "  set Report = false\n  set Output directory = "
        << (scratch.path() / "results").string() << "\nend\n";
  MPI_Barrier(MPI_COMM_WORLD);
  ::testing::internal::CaptureStdout();
  const auto end  = run_study(MPI_COMM_WORLD, path, quiet());
  const auto text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(end.n_failed, 0);
  if (rank() != 0)
    return;
  // Too short a time: both ends are undecided, which is said, and nothing is searched.
  EXPECT_TRUE(contains(text, "the range does not hold it: 'undecided' at 300 m/s")) << text;
  const auto lines = split(read_text(scratch.path() / "results" / "limits.csv"), '\n');
  EXPECT_EQ(lines.at(0), "group,speed_m_s_low,speed_m_s_high,speed_m_s,half_width,low_outcome,"
                         "high_outcome,runs,status");
  EXPECT_TRUE(contains(lines.at(1), "-,300.0,500.0,-,-,undecided,undecided,2,")) << lines[1];
  const auto record =
      nlohmann::ordered_json::parse(read_text(scratch.path() / "results" / "study.json"));
  EXPECT_EQ(record["limits"][0]["is_found"], false);
}

TEST(Study, ACaseThatAnotherProcessRunsIsLeftToIt)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s");
  auto resume     = quiet();
  resume.resume   = true;
  ::testing::internal::CaptureStdout();
  {
    const CaseLock lock(MPI_COMM_WORLD,
                        scratch.path() / "results" / ".locks" / "base__speed_300_m_s");
    EXPECT_TRUE(lock.is_held());
    run_study(MPI_COMM_WORLD, path, resume);
  }
  if (rank() == 0)
  {
    const auto lines = split(read_text(scratch.path() / "results" / "study.csv"), '\n');
    EXPECT_TRUE(contains(lines.at(1), ",runs elsewhere")) << lines[1];
    EXPECT_TRUE(contains(lines.at(2), ",ok")) << lines[2];
  }
  run_study(MPI_COMM_WORLD, path, resume); // now it may
  ::testing::internal::GetCapturedStdout();
  if (rank() == 0)
  {
    EXPECT_TRUE(contains(read_text(scratch.path() / "results" / "study.csv"), "undecided"));
  }
}

TEST(Study, ThatIsInterruptedSaysWhatIsMissing)
{
  const ScratchDirectory scratch;
  const auto path = write_study(scratch.path(), "400 m/s", "5 ms");
  // Once there is a second line the run steps, and listens.
  std::thread user;
  if (rank() == 0)
    user = std::thread(
        [history = scratch.path() / "results" / "base__speed_300_m_s" / "history.csv"]
        {
          std::string line;
          for (int n_lines = 0; n_lines < 2;)
          {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            std::ifstream in(history); // which is not there at first
            for (n_lines = 0; std::getline(in, line);)
              ++n_lines;
          }
          kill(getpid(), SIGINT);
        });
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const StudyEnd end = run_study(MPI_COMM_WORLD, path, quiet());
  ::testing::internal::GetCapturedStdout();
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE(end.interrupted);
  if (rank() != 0)
    return;
  user.join();
  EXPECT_TRUE(contains(text, "Missing:\n  base__speed_300_m_s\n  base__speed_400_m_s\n")) << text;
  EXPECT_TRUE(contains(text, "--resume")) << text;
}
} // namespace
} // namespace ricochet
