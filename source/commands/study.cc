// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "comparison.h"
#include "convergence.h"
#include "limit_search.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/scene/study_file.h"
#include "study_case.h"
#include "study_price.h"
#include "study_runs.h"

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
  write_file(directory / "comparison.txt", comparison.advice);
  std::printf("\nCompared with %s. Path error: distance of the mean positions over the reference's "
              "path, at the latest\nstated time that all have reached; scatter: the same for the "
              "farthest run of the reference. Speed and cost:\nmedians. In brackets: single runs, "
              "from the smallest to the largest.\n\n%s\n%sAll of it stands in %s.\n",
              study.reference.c_str(), comparison.text.c_str(), comparison.advice.c_str(),
              (directory / "comparison.csv").c_str());
  std::fflush(stdout);
}

void write_convergence(const StudyParameters &study, const std::vector<Json> &summaries,
                       const std::filesystem::path &directory)
{
  const Convergence found = converge(study, summaries, directory);
  write_file(directory / "convergence.csv", found.csv);
  write_file(directory / "convergence_orders.csv", found.orders);
  std::printf(
      "\nErrors against the reference: of the path, the distance of the mean positions over "
      "the reference's path\nat the latest time that all have reached.\n\n%s",
      found.text.c_str());
  std::fflush(stdout);
}

/// What is said, drawn and written of a study.
class Study
{
public:
  Study(const MPI_Comm communicator, const StudyRuns &runs, const StudyOptions &options) :
    communicator_(communicator), runs_(runs), parameters_(runs.parameters()),
    directory_(runs.directory()), options_(options), speaks_(rank_in(communicator) == 0)
  {
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
    tell_of_limit();
    std::fflush(stdout);
  }

  void price() const
  {
    std::vector<bool> is_finished;
    for (const auto &summary : runs_.summaries())
      is_finished.push_back(!summary.is_null());
    print_prices(communicator_, parameters_, is_finished, options_.n_jobs);
    tell_of_limit();
    std::fflush(stdout);
  }

  /// After an interruption: what has not run to its end.
  void tell_missing() const
  {
    tell_names(
        "The study was interrupted. Missing:",
        [](const std::string &status) { return status.empty() || status == "interrupted"; },
        "The same command with --resume goes on with them.");
  }
  void tell_failed() const
  {
    tell_names("Failed:", has_failed, "Their rows in the table say why; --resume tries again.");
  }

  void report() const
  {
    if (speaks_)
      std::printf("\n%s\n\n%s\nThe table stands in %s.\n", parameters_.title.c_str(),
                  runs_.table().text().c_str(), (directory_ / "study.csv").c_str());
    if (speaks_ && parameters_.limit)
      std::printf("\n%s",
                  limits_text(parameters_, limit_searches(parameters_, runs_.summaries())).c_str());
    std::fflush(stdout);
    const bool is_compared = !parameters_.reference.empty();
    if (is_compared)
      on_first_rank(communicator_,
                    [&] { write_comparison(parameters_, runs_.summaries(), directory_); });
    if (parameters_.kind == StudyKind::convergence)
      on_first_rank(communicator_,
                    [&] { write_convergence(parameters_, runs_.summaries(), directory_); });
    if (parameters_.pictures)
      draw(is_compared);
    if (parameters_.report)
      write_report(communicator_, directory_, /*quiet=*/false);
  }

private:
  void draw(const bool is_compared) const
  {
    if (runs_.table().is_map())
      draw_stability_map(communicator_, directory_ / "study.csv", directory_ / "map.png",
                         /*quiet=*/false);
    else
      draw_study_picture(communicator_, directory_, /*quiet=*/false);
    if (is_compared)
      draw_accuracy_chart(communicator_, directory_, /*quiet=*/false);
  }

  void tell_of_limit() const
  {
    if (speaks_ && parameters_.limit)
      std::printf("The search for the limit adds cases, one after the other, as outcomes become "
                  "known.\n%s",
                  limits_text(parameters_, limit_searches(parameters_, runs_.summaries())).c_str());
  }

  template <class Condition>
  void tell_names(const char *const heading, const Condition &condition,
                  const char *const remedy) const
  {
    std::string names;
    for (std::size_t i = 0; i < runs_.statuses().size(); ++i)
      if (condition(runs_.statuses()[i]))
        names += "\n  " + parameters_.cases[i].name;
    if (speaks_ && !names.empty())
      std::cerr << "\n" << heading << names << "\n" << remedy << std::endl;
  }

  MPI_Comm communicator_;
  const StudyRuns &runs_;
  const StudyParameters &parameters_;
  const std::filesystem::path &directory_;
  StudyOptions options_;
  bool speaks_;
};
} // namespace

StudyEnd run_study(const MPI_Comm communicator, const std::string &path,
                   const StudyOptions &options)
{
  if (options.n_jobs > 1 && size_of(communicator) > 1)
    throw InputError("--jobs " + std::to_string(options.n_jobs) +
                     ": Cases side by side are processes of their own, and this study runs under "
                     "mpirun.\n  Start it without mpirun, or leave out --jobs.");
  StudyRuns runs(communicator, read_study(path), options);
  const Study study(communicator, runs, options);
  const bool only_looks = options.list || options.dry_run;
  if (only_looks || !options.only.empty())
    runs.look_back();
  if (options.list)
    study.list();
  else if (options.dry_run)
    study.price();
  if (only_looks)
    return {};
  if (!options.only.empty())
    return runs.run_one();
  runs.prepare_folder();
  const StudyEnd end = runs.run_cases();
  study.report();
  if (end.n_failed > 0)
    study.tell_failed();
  if (end.interrupted)
    study.tell_missing();
  return end;
}
} // namespace ricochet
