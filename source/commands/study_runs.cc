// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_runs.h"

#include "limit_search.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/result_directory.h"
#include "run.h"
#include "stability_run.h"
#include "study_jobs.h"
#include "warning.h"

#include <cstdio>

namespace ricochet
{
using Json = nlohmann::ordered_json;

StudyRuns::StudyRuns(const MPI_Comm communicator, StudyParameters parameters,
                     const StudyOptions &options) :
  communicator_(communicator),
  parameters_(std::move(parameters)), options_(options), directory_(parameters_.output_directory),
  speaks_(rank_in(communicator) == 0)
{
  take_over_cases();
}

void StudyRuns::prepare_folder()
{
  const bool may_hold      = options_.resume || options_.collect || !options_.only.empty();
  const bool holds_results = speaks_ && !may_hold && std::filesystem::exists(directory_) &&
                             !std::filesystem::is_empty(directory_);
  if (broadcast(communicator_, holds_results, /*root=*/0))
    throw FileError("The study's results folder '" + directory_.string() +
                    "' exists and is not empty. Use --resume to run only what is missing in it, "
                    "or remove it to start anew.");
  on_first_rank(communicator_, [&] { make_directory(directory_); });
}

void StudyRuns::look_back()
{
  for (std::size_t i = 0; i < parameters_.cases.size(); ++i)
  {
    summaries_[i] = earlier_run(communicator_, parameters_.cases[i].file,
                                directory_ / parameters_.cases[i].name)
                        .summary;
    if (i + 1 == parameters_.cases.size())
      add_next_cases();
  }
}

StudyEnd StudyRuns::run_one()
{
  const std::size_t i = number_of(options_.only);
  prepare_folder();
  const auto end = run_case(i);
  on_first_rank(communicator_,
                [&] { leave_status(directory_, parameters_.cases[i].name, end.status); });
  if (speaks_)
    std::printf("%s\n", end.status.c_str());
  std::fflush(stdout);
  return {has_failed(end.status), end.status == "interrupted"};
}

StudyEnd StudyRuns::run_cases()
{
  if (const auto warning = table_->warning(); !warning.empty())
    warn(communicator_, warning);
  StudyEnd end;
  for (std::size_t first = 0; first < parameters_.cases.size() && !end.interrupted;)
  {
    const std::size_t last = parameters_.cases.size();
    end.interrupted        = options_.n_jobs > 1 ? run_at_once(first) : run_in_turn(first);
    first                  = last;
    if (!end.interrupted)
      add_next_cases();
  }
  write_tables();
  for (const auto &status : statuses_)
    end.n_failed += has_failed(status);
  return end;
}

void StudyRuns::take_over_cases()
{
  table_ = std::make_unique<StudyTable>(parameters_);
  summaries_.resize(parameters_.cases.size());
  statuses_.resize(parameters_.cases.size());
  for (std::size_t i = 0; i < statuses_.size(); ++i)
    if (!statuses_[i].empty())
      table_->set(i, summaries_[i], statuses_[i]);
}

void StudyRuns::add_next_cases()
{
  if (!parameters_.limit)
    return;
  Json wanted = Json::array();
  if (speaks_)
    for (const auto &search : limit_searches(parameters_, summaries_))
      if (search.next)
        wanted.push_back({search.like, *search.next});
  wanted = Json::parse(broadcast(communicator_, wanted.dump(), /*root=*/0));
  for (const auto &one : wanted)
    add_limit_case(parameters_, one[0], one[1]);
  if (!wanted.empty())
    take_over_cases();
}

void StudyRuns::tell(const std::size_t i, const std::string &remark) const
{
  if (speaks_)
    std::printf("[%zu/%zu] %s%s\n", i + 1, parameters_.cases.size(),
                parameters_.cases[i].name.c_str(), remark.c_str());
  std::fflush(stdout);
}

std::size_t StudyRuns::number_of(const std::string &wanted) const
{
  const auto &cases = parameters_.cases;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (wanted == cases[i].name || wanted == std::to_string(i + 1))
      return i;
  throw InputError("--case " + wanted + ": The study '" + parameters_.path + "' has " +
                   std::to_string(cases.size()) +
                   " cases, and none of this number or name.\n  'ricochet study --list' numbers "
                   "them.");
}

void StudyRuns::keep(const std::size_t i, const CaseEnd &end)
{
  summaries_[i] = end.summary;
  statuses_[i]  = end.status;
  table_->set(i, end.summary, end.status);
  write_tables();
}

void StudyRuns::write_tables() const
{
  on_first_rank(communicator_,
                [&]
                {
                  Json more = Json::object();
                  if (parameters_.limit)
                  {
                    const auto searches = limit_searches(parameters_, summaries_);
                    more["limits"]      = limits_json(parameters_, searches);
                    write_file(directory_ / "limits.csv", limits_csv(parameters_, searches));
                  }
                  write_file(directory_ / "study.csv", table_->csv());
                  write_file(directory_ / "study.json", table_->json(more));
                });
}

bool StudyRuns::run_in_turn(const std::size_t first)
{
  for (std::size_t i = first; i < parameters_.cases.size(); ++i)
  {
    keep(i, run_case(i));
    if (statuses_[i] == "interrupted")
      return true;
  }
  return false;
}

bool StudyRuns::run_at_once(const std::size_t first)
{
  std::vector<std::size_t> numbers;
  for (std::size_t i = first; i < parameters_.cases.size(); ++i)
  {
    const auto &one = parameters_.cases[i];
    if (auto earlier = earlier_run(communicator_, one.file, directory_ / one.name);
        earlier.summary.is_null() && !options_.collect)
      numbers.push_back(i);
    else
      keep(i, run_case(i));
  }
  return run_side_by_side(parameters_, numbers, options_.n_jobs, options_.quiet,
                          [this](const std::size_t i, const CaseEnd &end) { keep(i, end); });
}

CaseEnd StudyRuns::run_case(const std::size_t i) const
{
  const ParameterFile &file = parameters_.cases[i].file;
  const std::string &name   = parameters_.cases[i].name;
  const CaseLock lock(communicator_, lock_of(directory_, name));
  if (!lock.is_held())
  {
    tell(i, ": another process runs it");
    return {"runs elsewhere", {}};
  }
  auto earlier             = earlier_run(communicator_, file, directory_ / name);
  const bool is_finished   = !earlier.summary.is_null();
  const std::string remark = is_finished               ? ": finished before"
                             : earlier.why_not.empty() ? ""
                                                       : ": run again, " + earlier.why_not;
  if (options_.collect && !is_finished)
    return {earlier.why_not.empty() ? "missing" : "missing: " + earlier.why_not, {}};
  tell(i, remark);
  if (is_finished)
    return {"finished before", std::move(earlier.summary)};
  try
  {
    RunOptions run_options;
    run_options.force = true; // an unfinished run of an earlier try may lie there
    run_options.quiet = options_.quiet;
    Json summary      = (parameters_.cases[i].is_experiment ? run_stability : run_scene)(
        communicator_, file, run_options);
    const bool interrupted = summary.value("interrupted", false);
    return {interrupted ? "interrupted" : "ok", std::move(summary)};
  }
  catch (const Error &error)
  {
    return {std::string("failed: ") + error.what(), {}};
  }
}
} // namespace ricochet
