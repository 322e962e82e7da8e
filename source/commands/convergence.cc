// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convergence.h"

#include "grid_levels.h"
#include "observed_order.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/table.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/scene_reader.h"
#include "ricochet/scene/text_tools.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// Mean of values and its standard error.
struct Mean
{
  double value, error;
};

std::optional<Mean> mean_of(const std::vector<double> &values)
{
  if (values.empty())
    return {};
  const auto n = static_cast<double>(values.size());
  double sum = 0., squares = 0.;
  for (const double value : values)
    sum += value;
  for (const double value : values)
    squares += std::pow(value - sum / n, 2);
  return Mean{sum / n, n > 1. ? std::sqrt(squares / (n - 1.) / n) : 0.};
}

/// A quantity of all runs of a level; nothing if one of them has none.
std::optional<Mean> mean_of(const GridLevel &level, const std::vector<Json> &summaries,
                            const std::string &quantity)
{
  if (quantity == "path_mm")
    return mean_of(level.paths);
  std::vector<double> values;
  for (const std::size_t i : level.cases)
  {
    const auto &summary    = summaries[i];
    const auto outcome     = summary.value("outcome", std::string());
    const bool has_left    = outcome != "undecided" && outcome != "stuck";
    const auto value       = summary.find(quantity);
    const bool is_a_number = value != summary.end() && value->is_number();
    if (!is_a_number || (quantity == "exit_speed_m_s" && !has_left))
      return {};
    values.push_back(value->get<double>());
  }
  return mean_of(values);
}

/// What is compared: the path, the exit, and the craters.
std::vector<std::string> quantities_of(const std::vector<Json> &summaries)
{
  std::vector<std::string> quantities{"path_mm", "exit_speed_m_s", "max_depth_mm"};
  for (int plate = 1;; ++plate)
    for (const char *what : {"broken_share", "front_damaged_mm2", "rear_damaged_mm2"})
    {
      const std::string name = "plate_" + std::to_string(plate) + "_" + what;
      const auto is_there    = [&](const Json &summary)
      { return summary.is_object() && summary.contains(name); };
      if (!std::any_of(summaries.begin(), summaries.end(), is_there))
        return quantities;
      quantities.push_back(name);
    }
}

/// Diameter over size, or null if the axis is no length.
Json points_per_calibre(const StudyParameters &study, const GridLevel &level)
{
  const auto &column = study.axis_columns[0];
  const auto unit    = parse_free_quantity("1 " + column.unit);
  if (column.unit.empty() || !unit || unit->dimension != Dimension::length)
    return {};
  const Scene scene = read_scene(study.cases[level.cases[0]].file);
  return scene.projectile.shape.diameter / (level.size * unit->in_si);
}

Json relative(const std::optional<Mean> &value, const std::optional<Mean> &reference)
{
  if (!value || !reference || reference->value == 0.)
    return {};
  return 100. * (value->value / reference->value - 1.);
}

std::string percent_text(const Json &value)
{
  return value.is_number() ? with_digits(value.get<double>(), 2) : "-";
}

/// "1.9 +- 0.2", or "none: why".
std::string order_text(const ObservedOrder &observed)
{
  if (!observed.order)
    return "none: " + observed.why_none;
  return with_digits(*observed.order, 3) + (observed.uncertainty
                                                ? " +- " + with_digits(*observed.uncertainty, 2)
                                                : " (three grids: uncertainty unknown)");
}

ObservedOrder order_of(const GridGroup &group, const std::vector<Json> &summaries,
                       const std::string &quantity)
{
  std::vector<GridResult> grids;
  for (const auto &level : group.levels)
  {
    const auto mean = mean_of(level, summaries, quantity);
    if (!mean)
    {
      ObservedOrder none;
      none.why_none = "not every grid has a value";
      return none;
    }
    grids.push_back({level.size, mean->value, mean->error});
  }
  return observed_order(grids);
}

std::vector<std::string> columns_of(const StudyParameters &study,
                                    const std::vector<std::string> &quantities)
{
  std::vector<std::string> columns{"group", study.axis_columns[0].name, "points_per_calibre",
                                   "runs",  "compared_at_us",           "path_error_percent"};
  for (const auto &quantity : quantities)
    for (const std::string ending : {"", "_standard_error", "_error_percent"})
      if (quantity != "path_mm" || ending != "_error_percent") // the distance stands for it
        columns.push_back(quantity + ending);
  columns.insert(columns.end(), {"core_seconds", "reference"});
  return columns;
}

Json or_null(const std::optional<double> &value)
{
  return value ? Json(*value) : Json();
}
/// Gathers the tables, group by group.
class Tables
{
public:
  Tables(const StudyParameters &study, const std::vector<Json> &summaries) :
    study_(study), summaries_(summaries), quantities_(quantities_of(summaries)),
    table_(columns_of(study, quantities_)),
    orders_({"group", "quantity", "order", "uncertainty", "limit", "remark"}),
    shown_({"group", squeezed(study.axis_columns[0].label + " " + study.axis_columns[0].unit),
            "per calibre", "runs", "path error %", "exit speed error %", "core-seconds"})
  {
  }

  void add(const GridGroup &group)
  {
    const auto found =
        std::find_if(group.levels.begin(), group.levels.end(),
                     [&](const GridLevel &level) { return level.value == study_.finest; });
    const GridLevel *const reference = found != group.levels.end() ? &*found : nullptr;
    for (const auto &level : group.levels)
      add_level(group, level, reference);
    for (const auto &quantity : quantities_)
      add_order(group, quantity);
  }

  Convergence texts() const
  {
    return {table_.csv(), orders_.csv(), shown_.text() + "\nObserved order:\n" + order_lines_};
  }

private:
  void add_level(const GridGroup &group, const GridLevel &level, const GridLevel *const reference)
  {
    const auto path        = reference ? mean_of(reference->paths) : std::optional<Mean>();
    const Json path_error  = path && path->value > 0.
                                 ? Json(100. * (level.place - reference->place).norm() / path->value)
                                 : Json();
    const Json per_calibre = points_per_calibre(study_, level);
    const auto cost        = mean_of(level, summaries_, "core_seconds");
    std::vector<Json> row{name_of(group),     level.size, per_calibre,
                          level.cases.size(), group.time, path_error};
    Json speed_error;
    for (const auto &quantity : quantities_)
    {
      const auto mean = mean_of(level, summaries_, quantity);
      const auto wanted =
          reference ? mean_of(*reference, summaries_, quantity) : std::optional<Mean>();
      row.push_back(mean ? Json(mean->value) : Json());
      row.push_back(mean && level.cases.size() > 1 ? Json(mean->error) : Json());
      if (quantity != "path_mm")
        row.push_back(relative(mean, wanted));
      if (quantity == "exit_speed_m_s")
        speed_error = row.back();
    }
    const Json core_seconds = cost ? Json(cost->value) : Json();
    row.insert(row.end(), {core_seconds, &level == reference ? 1 : 0});
    table_.add(row);
    const auto told = [&](const Json &error)
    { return &level == reference ? "reference" : percent_text(error); };
    shown_.add({group.name, level.size, per_calibre, level.cases.size(), told(path_error),
                told(speed_error), core_seconds});
  }

  void add_order(const GridGroup &group, const std::string &quantity)
  {
    const auto observed = order_of(group, summaries_, quantity);
    orders_.add({name_of(group), quantity, or_null(observed.order), or_null(observed.uncertainty),
                 or_null(observed.limit),
                 observed.order ? Json() : Json("none: " + observed.why_none)});
    order_lines_ += "  " + quantity + (group.name.empty() ? "" : " (" + group.name + ")") + ": " +
                    order_text(observed) + "\n";
  }

  static Json name_of(const GridGroup &group)
  {
    return group.name.empty() ? Json() : Json(group.name);
  }

  const StudyParameters &study_;
  const std::vector<Json> &summaries_;
  std::vector<std::string> quantities_;
  Table table_, orders_, shown_;
  std::string order_lines_;
};
} // namespace

Convergence converge(const StudyParameters &study, const std::vector<Json> &summaries,
                     const std::filesystem::path &directory)
{
  Tables tables(study, summaries);
  for (const auto &group : grid_groups(study, summaries, directory))
    tables.add(group);
  return tables.texts();
}
} // namespace ricochet
