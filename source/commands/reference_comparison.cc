// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_comparison.h"

#include "history_rows.h"
#include "ricochet/base/number_text.h"
#include "ricochet/scene/text_tools.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

// Data with more times are a curve, whose single errors would fill a table [-].
constexpr std::size_t most_times = 8;

Json or_null(const std::optional<double> &value)
{
  return value ? Json(*value) : Json();
}

Json compare_column(const ReferenceData &data, const ReferenceData::Column &column,
                    const HistoryRows &rows)
{
  Json points = Json::array();
  double sum  = 0.;
  int n       = 0;
  for (std::size_t i = 0; i < data.times.size(); ++i)
    if (const auto wanted = column.values[i])
    {
      const Json found =
          or_null(interpolated(rows.at("time"), rows.at(column.name), data.times[i]));
      const double apart = found.is_null() ? 0. : found.get<double>() - *wanted;
      sum += apart * apart;
      n += !found.is_null();
      points.push_back(
          {{"time_us", data.times[i]},
           {"kind", data.kinds[i]},
           {"wanted", *wanted},
           {"error_bar", or_null(column.errors[i])},
           {"found", found},
           {"relative_error",
            found.is_null() || *wanted == 0. ? Json() : Json(apart / std::abs(*wanted))}});
    }
  return {{"name", column.name},
          {"unit", column.unit},
          {"rmse", n > 0 ? Json(std::sqrt(sum / n)) : Json()},
          {"points", points}};
}

std::string rmse_column(const std::string &name, const std::string &unit)
{
  return "reference_rmse_" + file_name_of(name + (unit == "-" ? "" : " " + unit));
}

std::string error_column(const std::string &name, const double time)
{
  return "reference_error_" + file_name_of(name + " " + number_text(time)) + "_us_percent";
}

std::string signed_percent(const Json &share)
{
  const double percent = 100. * share.get<double>();
  return (std::signbit(percent) ? "" : "+") + with_decimals(percent, 1) + " %";
}
} // namespace

Json compare_with_data(const std::filesystem::path &directory, const ReferenceData &data)
{
  const HistoryRows rows = read_history_rows(directory / "history.csv");
  Json columns           = Json::array();
  for (const auto &column : data.columns)
    columns.push_back(compare_column(data, column, rows));
  return {{"file", data.path}, {"source", data.source}, {"columns", columns}};
}

std::string describe_reference_data(const Json &summary)
{
  const auto found = summary.find("reference_data");
  if (found == summary.end() || !found->is_object())
    return "";
  std::string text = "against " + (*found)["file"].get<std::string>() + ":";
  for (const auto &column : (*found)["columns"])
  {
    text += "\n  " + column["name"].get<std::string>() + ":";
    std::size_t n_missing = 0;
    for (const auto &point : column["points"])
    {
      n_missing += point["found"].is_null();
      if (column["points"].size() <= most_times && !point["relative_error"].is_null())
        text += " " + signed_percent(point["relative_error"]) + " at " +
                number_text(point["time_us"]) + " us,";
    }
    text += column["rmse"].is_null() ? " not reached"
                                     : " root-mean-square error " + with_digits(column["rmse"], 4) +
                                           " " + column["unit"].get<std::string>();
    if (n_missing > 0 && !column["rmse"].is_null())
      text += " (" + std::to_string(n_missing) + " of " + std::to_string(column["points"].size()) +
              " times not reached)";
  }
  return text;
}

std::vector<std::string> reference_columns(const ReferenceData &data)
{
  std::vector<std::string> names;
  for (const auto &column : data.columns)
  {
    names.push_back(rmse_column(column.name, column.unit));
    if (data.times.size() <= most_times)
      for (std::size_t i = 0; i < data.times.size(); ++i)
        if (column.values[i])
          names.push_back(error_column(column.name, data.times[i]));
  }
  return names;
}

Json reference_value(const Json &summary, const std::string &wanted)
{
  const auto found = summary.is_object() ? summary.find("reference_data") : summary.end();
  if (!summary.is_object() || found == summary.end() || !found->is_object())
    return nullptr;
  for (const auto &column : (*found)["columns"])
  {
    if (wanted == rmse_column(column["name"], column["unit"]))
      return column["rmse"];
    for (const auto &point : column["points"])
      if (wanted == error_column(column["name"], point["time_us"]))
        return point["relative_error"].is_null()
                   ? Json()
                   : Json(100. * point["relative_error"].get<double>());
  }
  return nullptr;
}
} // namespace ricochet
