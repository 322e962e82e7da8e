// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_table.h"

#include "command_line.h"
#include "reference_comparison.h"
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

/// What the summaries of the cases may have.
struct KnownFields
{
  Names fields;
  Names of_data; // columns that a comparison with somebody else's data fills
};

KnownFields known_fields(const StudyParameters &study)
{
  KnownFields known;
  std::size_t n_plates = 0;
  bool any_experiment  = false;
  for (const auto &one : study.cases)
    if (one.is_experiment)
      any_experiment = true;
    else
    {
      const Scene scene = read_scene(one.file);
      n_plates          = std::max(n_plates, scene.plates.size());
      if (const auto data = reference_data_of(scene))
        for (const auto &column : reference_columns(*data))
          if (!has(known.of_data, column))
            known.of_data.push_back(column);
    }
  for (const auto &field : n_plates > 0 ? summary_fields() : std::vector<SummaryField>())
    if (field.place.empty())
      known.fields.push_back(field.name);
    else if (field.place == "plate_N_")
      for (std::size_t i = 1; i <= n_plates; ++i)
        known.fields.push_back("plate_" + std::to_string(i) + "_" + field.name);
  for (const auto &name : any_experiment ? stability_fields() : Names())
    known.fields.push_back(name);
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
  const auto known = known_fields(study);
  auto allowed     = known.fields;
  allowed.insert(allowed.end(), known.of_data.begin(), known.of_data.end());
  check_columns(study, allowed);
  Names fields;
  for (const auto &name : !study.columns.empty()   ? study.columns
                          : are_experiments(study) ? stability_columns
                                                   : default_fields)
    if (!has(fields, name) && std::none_of(study.axis_columns.begin(), study.axis_columns.end(),
                                           [&](const auto &axis) { return axis.name == name; }))
      fields.push_back(name);
  for (const auto &name : known.of_data)
    if (!has(fields, name))
      fields.push_back(name);
  return fields;
}

Names columns_of(const StudyParameters &study, const Names &fields, const StudyPlates &plates,
                 const bool with_axes)
{
  Names columns{"case"};
  for (const auto &axis : with_axes ? study.axis_columns : std::vector<StudyColumn>())
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
  record_(record_of(study, fields_)), values_(study.cases.size())
{
}

void StudyTable::set(const std::size_t number, const Json &summary, const std::string &status)
{
  auto &values = values_[number];
  values.clear();
  for (const auto &field : fields_)
    values.push_back(field.rfind("reference_", 0) == 0 ? reference_value(summary, field)
                     : summary.is_object()             ? summary.value(field, Json())
                                                       : Json());
  for (auto &extent : plates_.row(number))
    values.push_back(std::move(extent));
  values.emplace_back(status);
  record_["cases"][number]["status"] = status;
}

std::string StudyTable::csv() const
{
  Table table(columns_of(study_, fields_, plates_, true));
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!values_[i].empty())
    {
      std::vector<Json> row{study_.cases[i].name};
      for (const auto &value : study_.cases[i].axis_values)
        row.push_back(value_of(value));
      row.insert(row.end(), values_[i].begin(), values_[i].end());
      table.add(row);
    }
  return table.csv();
}

std::string StudyTable::text() const
{
  Table table(columns_of(study_, fields_, plates_, false));
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!values_[i].empty())
    {
      std::vector<Json> row{study_.cases[i].label};
      row.insert(row.end(), values_[i].begin(), values_[i].end());
      table.add(row);
    }
  return table.text();
}

std::string StudyTable::json(const Json &more) const
{
  Json record = record_;
  record.update(more);
  return record.dump(2) + "\n";
}
} // namespace ricochet
