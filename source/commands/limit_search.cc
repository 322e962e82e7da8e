// SPDX-License-Identifier: LGPL-2.1-or-later
#include "limit_search.h"

#include "ricochet/base/number_text.h"
#include "ricochet/output/table.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

// Values that differ by less than this share of the range are the same: rounding of decimal text.
constexpr double rounding = 1e-8;

/// The cases under one set of values of the other axes.
struct Group
{
  std::string scene;
  std::vector<std::size_t> others; // numbers of the values of all axes but the last
  std::vector<std::size_t> cases;
};

std::vector<Group> groups_of(const StudyParameters &study)
{
  std::vector<Group> groups;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
  {
    auto others = study.cases[i].values;
    others.pop_back();
    auto group =
        std::find_if(groups.begin(), groups.end(),
                     [&](const Group &other)
                     { return other.scene == study.cases[i].scene && other.others == others; });
    if (group == groups.end())
      group = groups.insert(groups.end(), {study.cases[i].scene, others, {}});
    group->cases.push_back(i);
  }
  return groups;
}

std::string name_of(const StudyParameters &study, const Group &group)
{
  std::vector<std::string> parts;
  if (study.scenes.size() > 1)
    parts.push_back(group.scene);
  const auto &values = study.cases[group.cases[0]].axis_values;
  for (std::size_t c = 0; c < study.limit->column; ++c)
  {
    const auto &column = study.axis_columns[c];
    parts.push_back(column.unit.empty() ? column.label + " " + values[c].text : values[c].text);
  }
  return joined(parts);
}

/// What the runs of a group say about values.
class Outcomes
{
public:
  Outcomes(const StudyParameters &study, const Group &group, const std::vector<Json> &summaries) :
    study_(study), group_(group), summaries_(summaries)
  {
  }

  std::optional<std::size_t> case_at(const double value) const
  {
    const auto &limit = *study_.limit;
    for (const std::size_t i : group_.cases)
      if (const auto number = study_.cases[i].axis_values[limit.column].number;
          number && std::abs(*number - value) <= rounding * (limit.high - limit.low))
        return i;
    return {};
  }

  /// "" if there is none (yet).
  std::string at(const double value) const
  {
    const auto found = case_at(value);
    return found && summaries_[*found].is_object() &&
                   !summaries_[*found].value("interrupted", true) &&
                   !summaries_[*found].value("failed", true)
               ? summaries_[*found].value("outcome", std::string())
               : "";
  }

private:
  const StudyParameters &study_;
  const Group &group_;
  const std::vector<Json> &summaries_;
};

/// Whether the outcome is the one meant, or any but the other one.
bool is_meant(const std::string &outcome, const std::string &meant, const std::string &other)
{
  return meant == "other" ? outcome != other && outcome != "undecided" : outcome == meant;
}

std::string with_unit(const StudyParameters &study, const double value)
{
  const auto &unit = study.axis_columns[study.limit->column].unit;
  return with_digits(value, 6) + (unit.empty() ? "" : " " + unit);
}

void bisect(const StudyParameters &study, const Outcomes &outcomes, LimitSearch &search)
{
  const auto &limit = *study.limit;
  while (search.high - search.low > limit.tolerance * (1. + rounding))
  {
    const double middle       = 0.5 * (search.low + search.high);
    const std::string outcome = outcomes.at(middle);
    if (outcome.empty())
    {
      if (outcomes.case_at(middle))
        search.reason = "the run at " + with_unit(study, middle) + " has not ended";
      else
        search.next = middle;
      return;
    }
    ++search.n_runs;
    const bool is_below = is_meant(outcome, limit.below, limit.above);
    if (!is_below && !is_meant(outcome, limit.above, limit.below))
    {
      search.reason = "the outcome at " + with_unit(study, middle) + " is '" + outcome +
                      "', neither '" + limit.below + "' nor '" + limit.above + "'" +
                      (outcome == "undecided" ? "; a later Time/Final time may decide it" : "");
      return;
    }
    (is_below ? search.low : search.high)                 = middle;
    (is_below ? search.low_outcome : search.high_outcome) = outcome;
  }
  search.is_found = true;
}

LimitSearch search_in(const StudyParameters &study, const Group &group,
                      const std::vector<Json> &summaries)
{
  const auto &limit = *study.limit;
  const Outcomes outcomes(study, group, summaries);
  LimitSearch search{name_of(study, group), group.cases[0], 0, limit.low, limit.high, "", ""};
  search.low_outcome  = outcomes.at(limit.low);
  search.high_outcome = outcomes.at(limit.high);
  search.n_runs       = !search.low_outcome.empty() + !search.high_outcome.empty();
  if (search.n_runs < 2)
    search.reason = "the runs at the ends of the range have not both ended";
  else if (!is_meant(search.low_outcome, limit.below, limit.above) ||
           !is_meant(search.high_outcome, limit.above, limit.below))
    search.reason = "the range does not hold it: '" + search.low_outcome + "' at " +
                    with_unit(study, limit.low) + ", '" + search.high_outcome + "' at " +
                    with_unit(study, limit.high);
  else
    bisect(study, outcomes, search);
  return search;
}

std::string state_of(const LimitSearch &search)
{
  return search.is_found ? "found" : search.next ? "to go on" : "not found: " + search.reason;
}

Json or_null(const std::string &text)
{
  return text.empty() ? Json() : Json(text);
}
} // namespace

std::vector<LimitSearch> limit_searches(const StudyParameters &study,
                                        const std::vector<Json> &summaries)
{
  std::vector<LimitSearch> searches;
  if (study.limit)
    for (const auto &group : groups_of(study))
      searches.push_back(search_in(study, group, summaries));
  return searches;
}

std::string limits_csv(const StudyParameters &study, const std::vector<LimitSearch> &searches)
{
  const std::string name = study.axis_columns[study.limit->column].name;
  Table table({"group", name + "_low", name + "_high", name, "half_width", "low_outcome",
               "high_outcome", "runs", "status"});
  for (const auto &one : searches)
    table.add({or_null(one.group), one.low, one.high,
               one.is_found ? Json(0.5 * (one.low + one.high)) : Json(),
               one.is_found ? Json(0.5 * (one.high - one.low)) : Json(), or_null(one.low_outcome),
               or_null(one.high_outcome), one.n_runs, state_of(one)});
  return table.csv();
}

Json limits_json(const StudyParameters &study, const std::vector<LimitSearch> &searches)
{
  const auto &column = study.axis_columns[study.limit->column];
  Json limits        = Json::array();
  for (const auto &one : searches)
    limits.push_back({{"group", one.group},
                      {"case", study.cases[one.like].name},
                      {"axis", study.limit->column},
                      {"label", column.label},
                      {"unit", column.unit},
                      {"low", one.low},
                      {"high", one.high},
                      {"low_outcome", one.low_outcome},
                      {"high_outcome", one.high_outcome},
                      {"runs", one.n_runs},
                      {"is_found", one.is_found},
                      {"status", state_of(one)}});
  return limits;
}

std::string limits_text(const StudyParameters &study, const std::vector<LimitSearch> &searches)
{
  const auto &limit = *study.limit;
  std::string text;
  for (const auto &one : searches)
  {
    text += "Limit between " + limit.below + " and " + limit.above +
            (one.group.empty() ? "" : " (" + one.group + ")") + ": ";
    text += one.is_found ? study.axis_columns[limit.column].label + " " +
                               with_unit(study, 0.5 * (one.low + one.high)) + " +- " +
                               with_unit(study, 0.5 * (one.high - one.low)) + ", from " +
                               std::to_string(one.n_runs) + " runs: " + one.low_outcome + " at " +
                               with_unit(study, one.low) + ", " + one.high_outcome + " at " +
                               with_unit(study, one.high)
                         : state_of(one) + " (between " + with_unit(study, one.low) + " and " +
                               with_unit(study, one.high) + ")";
    text += "\n";
  }
  return text;
}
} // namespace ricochet
