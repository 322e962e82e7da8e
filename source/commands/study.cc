// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "comparison.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/scene/study_file.h"
#include "run.h"
#include "stability_run.h"
#include "study_case.h"
#include "study_table.h"
#include "warning.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

void write_comparison(const StudyParameters &study, const std::vector<Json> &summaries,
                      const std::filesystem::path &directory)
{
  const Comparison comparison = compare_scenes(study, summaries);
  write_file(directory / "comparison.csv", comparison.csv);
  write_file(directory / "comparison_paths.csv", comparison.paths);
  std::printf("\nCompared with %s. Path error: distance of the mean positions over the reference's "
              "path, at the latest\nstated time that all have reached; scatter: the same for the "
              "farthest run of the reference. Speed and cost:\nmedians. In brackets: single runs, "
              "from the smallest to the largest.\n\n%s\nAll of it stands in %s.\n",
              study.reference.c_str(), comparison.text.c_str(),
              (directory / "comparison.csv").c_str());
  std::fflush(stdout);
}

/// All cases of a study, one after the other, and the table of what has come out.
class Study
{
public:
  Study(const MPI_Comm communicator, const StudyParameters &parameters,
        const StudyOptions &options) :
    communicator_(communicator),
    parameters_(parameters), options_(options), directory_(parameters.output_directory),
    table_(parameters), speaks_(rank_in(communicator) == 0), summaries_(parameters.cases.size())
  {
  }

  /// Throws FileError unless the folder is new, empty or may hold results.
  void prepare_folder()
  {
    const bool may_hold      = options_.resume || options_.collect || options_.only > 0;
    const bool holds_results = speaks_ && !may_hold && std::filesystem::exists(directory_) &&
                               !std::filesystem::is_empty(directory_);
    if (broadcast(communicator_, holds_results, /*root=*/0))
      throw FileError("The study's results folder '" + directory_.string() +
                      "' exists and is not empty. Use --resume to run only what is missing in it, "
                      "or remove it to start anew.");
    on_first_rank(communicator_, [&] { make_directory(directory_); });
  }

  /// What there is, and what is to be done; runs nothing.
  void list() const
  {
    for (std::size_t i = 0; i < parameters_.cases.size(); ++i)
    {
      const auto &one    = parameters_.cases[i];
      const auto earlier = earlier_run(communicator_, one.file, directory_ / one.name);
      if (speaks_)
        std::printf("%4zu  %s  (%s)  %s\n", i + 1, one.name.c_str(), one.label.c_str(),
                    !earlier.summary.is_null() ? "finished"
                    : earlier.why_not.empty()  ? "to run"
                                               : ("to run again: " + earlier.why_not).c_str());
    }
    std::fflush(stdout);
  }

  /// One of them alone, without tables and report.
  StudyEnd run_one(const std::size_t i)
  {
    const std::string status = run_case(i);
    if (speaks_)
      std::printf("%s\n", status.c_str());
    std::fflush(stdout);
    missing_from_ = parameters_.cases.size();
    return {status.rfind("failed", 0) == 0, status == "interrupted"};
  }

  StudyEnd run_cases()
  {
    if (const auto warning = table_.warning(); !warning.empty())
      warn(communicator_, warning);
    StudyEnd end;
    std::size_t i = 0;
    for (; i < parameters_.cases.size() && !end.interrupted; ++i)
    {
      const std::string status = run_case(i);
      end.interrupted          = status == "interrupted";
      end.n_failed += status.rfind("failed", 0) == 0;
      table_.add(i, summaries_[i], status);
      on_first_rank(communicator_,
                    [&]
                    {
                      write_file(directory_ / "study.csv", table_.csv());
                      write_file(directory_ / "study.json", table_.json());
                    });
    }
    missing_from_ = end.interrupted ? i - 1 : i;
    return end;
  }

  /// After an interruption: what has not run to its end.
  void tell_missing() const
  {
    std::string names;
    for (std::size_t i = missing_from_; i < parameters_.cases.size(); ++i)
      names += "\n  " + parameters_.cases[i].name;
    if (speaks_ && !names.empty())
      std::cerr << "\nThe study was interrupted. Missing:" << names
                << "\nThe same command with --resume goes on with them." << std::endl;
  }

  void report()
  {
    if (speaks_)
      std::printf("\n%s\n\n%s\nThe table stands in %s.\n", parameters_.title.c_str(),
                  table_.text().c_str(), (directory_ / "study.csv").c_str());
    std::fflush(stdout);
    const bool is_compared = !parameters_.reference.empty();
    if (is_compared)
      on_first_rank(communicator_, [&] { write_comparison(parameters_, summaries_, directory_); });
    if (parameters_.pictures)
      draw(is_compared);
    if (parameters_.report)
      write_report(communicator_, directory_, /*quiet=*/false);
  }

private:
  void draw(const bool is_compared) const
  {
    if (table_.is_map())
      draw_stability_map(communicator_, directory_ / "study.csv", directory_ / "map.png",
                         /*quiet=*/false);
    else
      draw_study_picture(communicator_, directory_, /*quiet=*/false);
    if (is_compared)
      draw_accuracy_chart(communicator_, directory_, /*quiet=*/false);
  }

  void tell(const std::size_t i, const std::string &remark) const
  {
    if (speaks_)
      std::printf("[%zu/%zu] %s%s\n", i + 1, parameters_.cases.size(),
                  parameters_.cases[i].name.c_str(), remark.c_str());
    std::fflush(stdout);
  }

  /// Fills in its summary and returns its status for the table.
  std::string run_case(const std::size_t i)
  {
    const ParameterFile &file = parameters_.cases[i].file;
    const std::string &name   = parameters_.cases[i].name;
    Json &summary             = summaries_[i];
    const CaseLock lock(communicator_, directory_ / ".locks" / name);
    if (!lock.is_held())
    {
      tell(i, ": another process runs it");
      return "runs elsewhere";
    }
    auto earlier             = earlier_run(communicator_, file, directory_ / name);
    summary                  = std::move(earlier.summary);
    const bool is_finished   = !summary.is_null();
    const std::string remark = is_finished               ? ": finished before"
                               : earlier.why_not.empty() ? ""
                                                         : ": run again, " + earlier.why_not;
    if (options_.collect && !is_finished)
      return earlier.why_not.empty() ? "missing" : "missing: " + earlier.why_not;
    tell(i, remark);
    if (is_finished)
      return "finished before";
    try
    {
      RunOptions run_options;
      run_options.force = true; // an unfinished run of an earlier try may lie there
      run_options.quiet = options_.quiet;
      summary = (parameters_.cases[i].is_experiment ? run_stability : run_scene)(communicator_,
                                                                                 file, run_options);
      return summary.value("interrupted", false) ? "interrupted" : "ok";
    }
    catch (const Error &error)
    {
      return std::string("failed: ") + error.what();
    }
  }

  MPI_Comm communicator_;
  const StudyParameters &parameters_;
  StudyOptions options_;
  std::filesystem::path directory_;
  StudyTable table_;
  bool speaks_;
  std::size_t missing_from_ = 0; // cases from here on have not run to their end
  std::vector<Json> summaries_;  // of all cases; null if there is none
};
} // namespace

StudyEnd run_study(const MPI_Comm communicator, const std::string &path,
                   const StudyOptions &options)
{
  const StudyParameters parameters = read_study(path);
  const int n_cases                = static_cast<int>(parameters.cases.size());
  if (options.only < 0 || options.only > n_cases)
    throw InputError("--case " + std::to_string(options.only) + ": The study '" + path + "' has " +
                     std::to_string(n_cases) + " cases.\n  'ricochet study --list' numbers them.");
  Study study(communicator, parameters, options);
  if (options.list)
  {
    study.list();
    return {};
  }
  study.prepare_folder();
  if (options.only > 0)
    return study.run_one(options.only - 1);
  const StudyEnd end = study.run_cases();
  study.report();
  if (end.interrupted)
    study.tell_missing();
  return end;
}
} // namespace ricochet
