// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/drivers/study.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/drivers/run.h"
#include "ricochet/drivers/stability_run.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/pictures.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/stability_reader.h"
#include "ricochet/scene/study_file.h"

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
    write_used_parameters(ParameterFile(c.scene_file, c.overrides), used);
    summary =
        Json::parse(read_text(directory / "summary.json"), nullptr, /*allow_exceptions=*/false);
    finished = summary.is_object() && !summary.value("failed", true) &&
               !summary.value("interrupted", true) &&
               read_text(directory / "used.prm") == used.str();
  }
  MPI_Bcast(&finished, 1, MPI_INT, 0, communicator);
  return finished ? (summary.is_object() ? summary : Json::object()) : Json();
}

/// Four digits for the eye; all of them for the CSV.
std::string cell_text(const Json &value, const bool all_digits)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_number_integer() || value.is_boolean() || (all_digits && value.is_number()))
    return value.dump();
  if (!value.is_number())
    return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value.get<double>());
  return text;
}

class Table
{
public:
  explicit Table(const std::vector<std::string> &columns) : columns_(columns) {}

  void add(const std::string &name, const Json &summary, const std::string &status)
  {
    std::vector<Json> row{name};
    for (const auto &column : columns_)
      row.push_back(summary.is_object() ? summary.value(column, Json()) : Json());
    row.push_back(status);
    rows_.push_back(row);
  }

  std::string csv() const
  {
    std::string text;
    for (const auto &row : with_header(/*all_digits=*/true))
    {
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        std::string cell = row[i];
        if (cell.find_first_of(",\"\n") != std::string::npos)
        {
          for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2)
            cell.insert(at, 1, '"');
          cell = '"' + cell + '"';
        }
        text += (i ? "," : "") + cell;
      }
      text += '\n';
    }
    return text;
  }

  void print() const
  {
    const auto rows = with_header(/*all_digits=*/false);
    std::vector<std::size_t> width(rows[0].size(), 0);
    for (const auto &row : rows)
      for (std::size_t i = 0; i < row.size(); ++i)
        width[i] = std::max(width[i], row[i].size());
    for (const auto &row : rows)
    {
      for (std::size_t i = 0; i < row.size(); ++i)
        std::printf(i == 0                ? "%-*s"
                    : i + 1 == row.size() ? "  %-*s"
                                          : "  %*s",
                    i + 1 == row.size() ? 0 : static_cast<int>(width[i]), row[i].c_str());
      std::printf("\n");
    }
    std::fflush(stdout);
  }

private:
  std::vector<std::vector<std::string>> with_header(const bool all_digits) const
  {
    std::vector<std::vector<std::string>> rows{{"case"}};
    rows[0].insert(rows[0].end(), columns_.begin(), columns_.end());
    rows[0].push_back("status");
    for (const auto &row : rows_)
    {
      rows.emplace_back();
      for (const auto &cell : row)
        rows.back().push_back(cell_text(cell, all_digits));
    }
    return rows;
  }

  std::vector<std::string> columns_;
  std::vector<std::vector<Json>> rows_;
};

bool is_experiment(const StudyCase &c)
{
  return is_stability_file(ParameterFile(c.scene_file, c.overrides));
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
  const auto &cases         = parameters.cases;
  const bool is_map         = std::all_of(cases.begin(), cases.end(), is_experiment);
  const auto &usual_columns = is_map ? stability_columns : default_columns;
  Table table(parameters.columns.empty() ? usual_columns : parameters.columns);
  int n_failed = 0;
  for (std::size_t i = 0; i < parameters.cases.size(); ++i)
  {
    const auto &c      = parameters.cases[i];
    Json summary       = finished_summary(communicator, c, directory / c.name);
    std::string status = "finished before";
    if (speaks)
      std::printf("[%zu/%zu] %s%s\n", i + 1, parameters.cases.size(), c.name.c_str(),
                  summary.is_null() ? "" : ": finished before");
    std::fflush(stdout);
    if (summary.is_null())
      try
      {
        RunOptions run_options;
        run_options.force = true; // an unfinished run of an earlier try may lie there
        run_options.quiet = options.quiet;
        const ParameterFile file(c.scene_file, c.overrides);
        summary = (is_experiment(c) ? run_stability : run)(communicator, file, run_options);
        status  = summary.value("interrupted", false) ? "interrupted" : "ok";
      }
      catch (const Error &error)
      {
        status = std::string("failed: ") + error.what();
        ++n_failed;
      }
    table.add(c.name, summary, status);
    on_first_rank(communicator, [&] { write_file(directory / "study.csv", table.csv()); });
    if (status == "interrupted")
      break;
  }
  if (speaks)
  {
    std::printf("\n%s\n\n", parameters.title.c_str());
    table.print();
    std::printf("\nThe table stands in %s.\n", (directory / "study.csv").c_str());
    std::fflush(stdout);
  }
  if (parameters.pictures && is_map)
    draw_stability_map(communicator, directory / "study.csv", directory / "map.png",
                       /*quiet=*/false);
  else if (parameters.pictures)
    draw_study_picture(communicator, directory, /*quiet=*/false);
  return n_failed;
}
} // namespace ricochet
