// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_table.h"

#include "command_line.h"
#include "ricochet/base/version.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/simulation/run_summary.h"
#include "stability_run.h"

#include <algorithm>

namespace ricochet
{
namespace
{
using Json  = nlohmann::ordered_json;
using Names = std::vector<std::string>;

const Names default_fields{"outcome",   "exit_speed_m_s",  "exit_angle_deg",
                           "pitch_deg", "max_depth_mm",    "path_mm",
                           "time_us",   "energy_residual", "core_seconds"};

bool has(const Names &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// All fields that the summaries of the cases may have.
Names known_fields(const StudyParameters &study)
{
  Names known;
  std::size_t n_plates = 0;
  bool any_experiment  = false;
  for (const auto &one : study.cases)
    if (one.is_experiment)
      any_experiment = true;
    else
      n_plates = std::max(n_plates, read_scene(one.file).plates.size());
  for (const auto &field : summary_fields())
    if (field.place.empty())
      known.push_back(field.name);
    else if (field.place == "plate_N_")
      for (std::size_t i = 1; i <= n_plates; ++i)
        known.push_back("plate_" + std::to_string(i) + "_" + field.name);
  if (n_plates == 0)
    known.clear();
  if (any_experiment)
    for (const auto &name : stability_fields())
      known.push_back(name);
  return known;
}

bool are_experiments(const StudyParameters &study)
{
  return std::all_of(study.cases.begin(), study.cases.end(),
                     [](const StudyCase &one) { return one.is_experiment; });
}

/// Those that the table shows; a field that is an axis stands there once.
Names chosen_fields(const StudyParameters &study)
{
  check_columns(study, known_fields(study));
  Names fields;
  for (const auto &name : !study.columns.empty()   ? study.columns
                          : are_experiments(study) ? stability_columns
                                                   : default_fields)
    if (!has(fields, name) && std::none_of(study.axis_columns.begin(), study.axis_columns.end(),
                                           [&](const auto &axis) { return axis.name == name; }))
      fields.push_back(name);
  return fields;
}

Names columns_of(const StudyParameters &study, const Names &fields, const StudyPlates &plates)
{
  Names columns{"case"};
  for (const auto &axis : study.axis_columns)
    columns.push_back(axis.name);
  columns.insert(columns.end(), fields.begin(), fields.end());
  columns.insert(columns.end(), plates.columns().begin(), plates.columns().end());
  columns.push_back("status");
  return columns;
}

Json value_of(const AxisValue &value)
{
  return value.number ? Json(*value.number) : value.text.empty() ? Json() : Json(value.text);
}

Json record_of(const StudyParameters &study, const Names &fields)
{
  Json record{{"title", study.title}, {"file", study.path},           {"command", command_line()},
              {"version", version()}, {"reference", study.reference}, {"axes", Json::array()},
              {"columns", fields},    {"cases", Json::array()}};
  for (const auto &axis : study.axis_columns)
    record["axes"].push_back({{"name", axis.name},
                              {"label", axis.label},
                              {"unit", axis.unit},
                              {"is_number", axis.is_number}});
  for (const auto &one : study.cases)
  {
    Json values = Json::array();
    for (const auto &value : one.axis_values)
      values.push_back(value_of(value));
    record["cases"].push_back({{"name", one.name},
                               {"label", one.label},
                               {"scene", one.scene},
                               {"axes", values},
                               {"status", "not run"}});
  }
  return record;
}
} // namespace

StudyTable::StudyTable(const StudyParameters &study) :
  study_(study), plates_(study), is_map_(are_experiments(study)), fields_(chosen_fields(study)),
  table_(columns_of(study, fields_, plates_)), record_(record_of(study, fields_))
{
}

void StudyTable::add(const std::size_t number, const Json &summary, const std::string &status)
{
  std::vector<Json> row{study_.cases[number].name};
  for (const auto &value : study_.cases[number].axis_values)
    row.push_back(value_of(value));
  for (const auto &field : fields_)
    row.push_back(summary.is_object() ? summary.value(field, Json()) : Json());
  for (auto &extent : plates_.row(number))
    row.push_back(std::move(extent));
  row.emplace_back(status);
  table_.add(row);
  record_["cases"][number]["status"] = status;
}
} // namespace ricochet
