// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_jobs.h"

#include "ricochet/output/job_pool.h"

#include <csignal>
#include <cstdio>

namespace ricochet
{
namespace
{
/// How a case ended whose process has: by what it has left behind.
CaseEnd end_of(const std::filesystem::path &directory, const std::string &name, const int exit,
               const bool interrupted)
{
  CaseEnd end{left_status(directory, name), {}};
  forget_status(directory, name);
  if (end.status.empty() && interrupted)
    end.status = "interrupted"; // before it could say so
  else if (end.status.empty())
    end.status = "failed: its process ended " +
                 (exit == not_started ? "before it began"
                  : exit < 0          ? "by signal " + std::to_string(-exit)
                                      : "with status " + std::to_string(exit)) +
                 " and left no word; is there enough memory for so many at a time?";
  if (end.status == "ok" || end.status == "finished before" || end.status == "interrupted")
    end.summary = summary_in(directory / name);
  return end;
}
} // namespace

bool run_side_by_side(const StudyParameters &study, const std::vector<std::size_t> &numbers,
                      const int n_jobs, const bool quiet,
                      const std::function<void(std::size_t, const CaseEnd &)> &ended)
{
  const std::filesystem::path directory = study.output_directory;
  std::vector<Job> jobs;
  for (const std::size_t i : numbers)
  {
    jobs.push_back({this_program().string(), "study", study.path, "--case", study.cases[i].name});
    if (quiet)
      jobs.back().emplace_back("--quiet");
  }

  const auto in_front = [&](const std::size_t job)
  { return std::to_string(numbers[job] + 1) + "/" + std::to_string(study.cases.size()); };
  JobListener listener;
  listener.started = [&](const std::size_t job)
  { forget_status(directory, study.cases[numbers[job]].name); };
  listener.line = [&](const std::size_t job, const std::string &line)
  {
    // What a process says of its case begins with that number itself, as far as it knows it.
    const auto text =
        !line.empty() && line.front() == '[' ? line.substr(line.find("] ") + 2) : line;
    if (!text.empty())
      std::printf("[%s] %s\n", in_front(job).c_str(), text.c_str());
    std::fflush(stdout);
  };
  listener.ended = [&](const std::size_t job, const int exit)
  {
    const auto &one = study.cases[numbers[job]];
    const auto end  = end_of(directory, one.name, exit, exit == -SIGINT);
    ended(numbers[job], end);
  };
  return run_jobs(jobs, n_jobs, listener);
}
} // namespace ricochet
