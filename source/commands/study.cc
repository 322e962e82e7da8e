// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study.h"

#include "comparison.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/output/table.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/study_file.h"
#include "run.h"
#include "stability_run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

const std::vector<std::string> default_columns{"outcome",   "exit_speed_m_s",  "exit_angle_deg",
                                               "pitch_deg", "max_depth_mm",    "path_mm",
                                               "time_us",   "energy_residual", "core_seconds"};

std::string read_text(const std::filesystem::path &path)
{
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The summary of an earlier, complete run with the same parameters, or null. The same on all
/// ranks.
Json finished_summary(const MPI_Comm communicator, const StudyCase &c,
                      const std::filesystem::path &directory)
{
  Json summary;
  int finished = 0;
  if (rank_in(communicator) == 0)
  {
    std::ostringstream used;
    write_used_parameters(c.file, used);
    summary =
        Json::parse(read_text(directory / "summary.json"), nullptr, /*allow_exceptions=*/false);
    finished = summary.is_object() && !summary.value("failed", true) &&
               !summary.value("interrupted", true) &&
               read_text(directory / "used.prm") == used.str();
  }
  MPI_Bcast(&finished, 1, MPI_INT, 0, communicator);
  return finished ? (summary.is_object() ? summary : Json::object()) : Json();
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
} // namespace

int study(const MPI_Comm communicator, const std::string &path, const StudyOptions &options)
{
  const StudyParameters parameters      = read_study(path);
  const std::filesystem::path directory = parameters.output_directory;
  const bool speaks                     = rank_in(communicator) == 0;
  if (!options.resume)
  {
    int exists = 0;
    if (speaks)
      exists = std::filesystem::exists(directory) && !std::filesystem::is_empty(directory);
    MPI_Bcast(&exists, 1, MPI_INT, 0, communicator);
    if (exists)
      throw FileError("The study's results folder '" + directory.string() +
                      "' exists and is not empty. Use --resume to run only what is missing in it, "
                      "or remove it to start anew.");
  }
  on_first_rank(communicator, [&] { make_directory(directory); });

  // A map of stability if every case is an experiment; experiments and scenes do not share columns.
  const auto &cases = parameters.cases;
  const bool is_map =
      std::all_of(cases.begin(), cases.end(), [](const StudyCase &c) { return c.is_experiment; });
  const auto &usual_columns = is_map ? stability_columns : default_columns;
  const auto &chosen        = parameters.columns.empty() ? usual_columns : parameters.columns;
  std::vector<std::string> columns{"case"};
  columns.insert(columns.end(), chosen.begin(), chosen.end());
  columns.push_back("status");
  Table table(columns);
  std::vector<Json> summaries(cases.size());
  int n_failed = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const auto &c      = cases[i];
    Json summary       = finished_summary(communicator, c, directory / c.name);
    std::string status = "finished before";
    if (speaks)
      std::printf("[%zu/%zu] %s%s\n", i + 1, cases.size(), c.name.c_str(),
                  summary.is_null() ? "" : ": finished before");
    std::fflush(stdout);
    if (summary.is_null())
      try
      {
        RunOptions run_options;
        run_options.force = true; // an unfinished run of an earlier try may lie there
        run_options.quiet = options.quiet;
        summary = (c.is_experiment ? run_stability : run)(communicator, c.file, run_options);
        status  = summary.value("interrupted", false) ? "interrupted" : "ok";
      }
      catch (const Error &error)
      {
        status = std::string("failed: ") + error.what();
        ++n_failed;
      }
    std::vector<Json> row{c.name};
    for (const auto &column : chosen)
      row.push_back(summary.is_object() ? summary.value(column, Json()) : Json());
    row.push_back(status);
    table.add(row);
    summaries[i] = summary;
    on_first_rank(communicator, [&] { write_file(directory / "study.csv", table.csv()); });
    if (status == "interrupted")
      break;
  }
  if (speaks)
  {
    std::printf("\n%s\n\n", parameters.title.c_str());
    std::printf("%s\nThe table stands in %s.\n", table.text().c_str(),
                (directory / "study.csv").c_str());
    std::fflush(stdout);
  }
  if (!parameters.reference.empty())
    on_first_rank(communicator, [&] { write_comparison(parameters, summaries, directory); });
  if (parameters.pictures && is_map)
    draw_stability_map(communicator, directory / "study.csv", directory / "map.png",
                       /*quiet=*/false);
  else if (parameters.pictures)
    draw_study_picture(communicator, directory, /*quiet=*/false);
  if (parameters.pictures && !parameters.reference.empty())
    draw_accuracy_chart(communicator, directory, /*quiet=*/false);
  return n_failed;
}
} // namespace ricochet
