// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "comparison.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/study_file.h"
#include "run.h"
#include "stability_run.h"
#include "study_table.h"
#include "warning.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

std::string read_text(const std::filesystem::path &path)
{
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The summary of an earlier, complete run with the same parameters in the folder, or null. The
/// same on all ranks.
Json finished_summary(const MPI_Comm communicator, const ParameterFile &file,
                      const std::filesystem::path &directory)
{
  Json summary;
  bool finished = false;
  if (rank_in(communicator) == 0)
  {
    std::ostringstream used;
    write_used_parameters(file, used);
    summary =
        Json::parse(read_text(directory / "summary.json"), nullptr, /*allow_exceptions=*/false);
    finished = summary.is_object() && !summary.value("failed", true) &&
               !summary.value("interrupted", true) &&
               read_text(directory / "used.prm") == used.str();
  }
  return broadcast(communicator, finished, /*root=*/0)
             ? (summary.is_object() ? summary : Json::object())
             : Json();
}

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
    const bool holds_results = speaks_ && !options_.resume && std::filesystem::exists(directory_) &&
                               !std::filesystem::is_empty(directory_);
    if (broadcast(communicator_, holds_results, /*root=*/0))
      throw FileError("The study's results folder '" + directory_.string() +
                      "' exists and is not empty. Use --resume to run only what is missing in it, "
                      "or remove it to start anew.");
    on_first_rank(communicator_, [&] { make_directory(directory_); });
  }

  /// Returns the number of cases that failed.
  int run_cases()
  {
    if (const auto warning = table_.warning(); !warning.empty())
      warn(communicator_, warning);
    int n_failed       = 0;
    std::string status = "";
    for (std::size_t i = 0; i < parameters_.cases.size() && status != "interrupted"; ++i)
    {
      status = run_case(i);
      n_failed += status.rfind("failed", 0) == 0;
      table_.add(i, summaries_[i], status);
      on_first_rank(communicator_,
                    [&]
                    {
                      write_file(directory_ / "study.csv", table_.csv());
                      write_file(directory_ / "study.json", table_.json());
                    });
    }
    return n_failed;
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

  /// Fills in its summary and returns its status for the table.
  std::string run_case(const std::size_t i)
  {
    const ParameterFile &file = parameters_.cases[i].file;
    const std::string &name   = parameters_.cases[i].name;
    Json &summary             = summaries_[i];
    summary                   = finished_summary(communicator_, file, directory_ / name);
    const bool is_finished    = !summary.is_null();
    if (speaks_)
      std::printf("[%zu/%zu] %s%s\n", i + 1, parameters_.cases.size(), name.c_str(),
                  is_finished ? ": finished before" : "");
    std::fflush(stdout);
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
  std::vector<Json> summaries_; // of all cases; null if there is none
};
} // namespace

int run_study(const MPI_Comm communicator, const std::string &path, const StudyOptions &options)
{
  const StudyParameters parameters = read_study(path);
  Study study(communicator, parameters, options);
  study.prepare_folder();
  const int n_failed = study.run_cases();
  study.report();
  return n_failed;
}
} // namespace ricochet
