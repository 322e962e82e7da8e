// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "comparison.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/output/summary.h"
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
#include <iostream>
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

/// What an earlier run has left of a case: its summary if that may stand, or why it may not.
struct Earlier
{
  Json summary;             // null: run it
  std::string why_not = ""; // "" if there is nothing at all
};

/// Whether the field is there, a truth value and false.
bool is_false(const Json &summary, const char *name)
{
  const auto field = summary.find(name);
  return field != summary.end() && field->is_boolean() && !field->get<bool>();
}

std::string reason_against(const Json &summary, const std::string &parameters,
                           const std::filesystem::path &directory)
{
  if (!summary.is_object())
    return "its summary.json cannot be read";
  if (summary.value("version", Json()) != version())
    return "it was made by another version, " + summary.value("version", Json("unknown")).dump();
  if (!is_untouched(summary))
    return "its summary.json has been changed";
  if (!is_false(summary, "failed"))
    return "it failed";
  if (!is_false(summary, "interrupted"))
    return "it was interrupted";
  if (read_text(directory / "used.prm") != parameters)
    return "its parameters are others now";
  return "";
}

/// The same on all ranks, but for the summary, which the first one has.
Earlier earlier_run(const MPI_Comm communicator, const ParameterFile &file,
                    const std::filesystem::path &directory)
{
  Earlier earlier;
  bool finished = false;
  if (rank_in(communicator) == 0 && std::filesystem::exists(directory / "summary.json"))
  {
    std::ostringstream used;
    write_used_parameters(file, used);
    earlier.summary = Json::parse(read_text(directory / "summary.json"), nullptr,
                                  /*allow_exceptions=*/false);
    earlier.why_not = reason_against(earlier.summary, used.str(), directory);
    finished        = earlier.why_not.empty();
  }
  if (!broadcast(communicator, finished, /*root=*/0))
    earlier.summary = Json();
  else if (earlier.summary.is_null())
    earlier.summary = Json::object();
  return earlier;
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

  /// Fills in its summary and returns its status for the table.
  std::string run_case(const std::size_t i)
  {
    const ParameterFile &file = parameters_.cases[i].file;
    const std::string &name   = parameters_.cases[i].name;
    Json &summary             = summaries_[i];
    auto earlier              = earlier_run(communicator_, file, directory_ / name);
    summary                   = std::move(earlier.summary);
    const bool is_finished    = !summary.is_null();
    const std::string remark  = is_finished               ? ": finished before"
                                : earlier.why_not.empty() ? ""
                                                          : ": run again, " + earlier.why_not;
    if (speaks_)
      std::printf("[%zu/%zu] %s%s\n", i + 1, parameters_.cases.size(), name.c_str(),
                  remark.c_str());
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
  std::size_t missing_from_ = 0; // cases from here on have not run to their end
  std::vector<Json> summaries_;  // of all cases; null if there is none
};
} // namespace

StudyEnd run_study(const MPI_Comm communicator, const std::string &path,
                   const StudyOptions &options)
{
  const StudyParameters parameters = read_study(path);
  Study study(communicator, parameters, options);
  study.prepare_folder();
  const StudyEnd end = study.run_cases();
  study.report();
  if (end.interrupted)
    study.tell_missing();
  return end;
}
} // namespace ricochet
