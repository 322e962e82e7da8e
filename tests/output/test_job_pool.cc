// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/job_pool.h"

#include "support/scratch_directory.h"

#include <algorithm>
#include <map>

namespace ricochet
{
namespace
{
using namespace tests;

/// What has been heard of jobs.
struct Heard
{
  std::vector<std::string> lines;
  std::map<std::size_t, int> ends;
  int n_running = 0, most_running = 0;

  JobListener listener()
  {
    return {[this](std::size_t) { most_running = std::max(most_running, ++n_running); },
            [this](const std::size_t job, const std::string &line)
            { lines.push_back(std::to_string(job) + ":" + line); },
            [this](const std::size_t job, const int status)
            {
              ends[job] = status;
              --n_running;
            }};
  }
};

Job shell(const std::string &script)
{
  return {"sh", "-c", script};
}

TEST(JobPool, RunsSoManyAtATimeAndTellsHowTheyEnd)
{
  Heard heard;
  const std::vector<Job> jobs{shell("exit 3"),
                              shell("kill -9 $$"),
                              {"there_is_no_such_program"},
                              shell("true"),
                              shell("echo $OMPI_COMM_WORLD_SIZE.")};
  setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
  EXPECT_FALSE(run_jobs(jobs, 2, heard.listener()));
  unsetenv("OMPI_COMM_WORLD_SIZE");
  EXPECT_EQ(heard.ends,
            (std::map<std::size_t, int>{{0, 3}, {1, -SIGKILL}, {2, not_started}, {3, 0}, {4, 0}}));
  EXPECT_EQ(heard.most_running, 2);
  EXPECT_EQ(heard.lines.back(), "4:."); // no marks of MPI
}

TEST(JobPool, LinesStayWhole)
{
  Heard heard;
  const std::string script = "for i in 1 2 3 4 5; do printf he; sleep 0.01; printf 'll\\no'; done";
  run_jobs({shell(script), shell(script)}, 2, heard.listener());
  ASSERT_EQ(heard.lines.size(), 12u);
  for (const std::string job : {"0:", "1:"})
  {
    EXPECT_EQ(std::count(heard.lines.begin(), heard.lines.end(), job + "hell"), 1);
    EXPECT_EQ(std::count(heard.lines.begin(), heard.lines.end(), job + "ohell"), 4);
    EXPECT_EQ(std::count(heard.lines.begin(), heard.lines.end(), job + "o"), 1); // without an end
  }
}

TEST(JobPool, AnInterruptionReachesAllAndStartsNoMore)
{
  Heard heard;
  auto listener = heard.listener();
  // Both have said that they listen: now the user presses Ctrl-C.
  listener.line = [&, n = 0](std::size_t, const std::string &) mutable
  {
    if (++n == 2)
      raise(SIGINT);
  };
  const std::string waits = "trap 'exit 7' INT; echo ready; while :; do sleep 0.02; done";
  EXPECT_TRUE(run_jobs({shell(waits), shell(waits), shell(waits)}, 2, listener));
  EXPECT_EQ(heard.ends, (std::map<std::size_t, int>{{0, 7}, {1, 7}}));
}
} // namespace
} // namespace ricochet
