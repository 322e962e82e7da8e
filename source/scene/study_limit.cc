// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_limit.h"

#include "ricochet/base/number_text.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/text_tools.h"
#include "study_axis.h"

#include <algorithm>

namespace ricochet
{
namespace
{
const char *const limit_example =
    "Write 'Section/Entry between outcome and outcome', for example 'Impact/Speed between ricochet "
    "and perforate'.";
const char *const range_example = "Write both ends with their unit, for example '500 m/s to 900 "
                                  "m/s'.";
// How a run can end and be decided, as summary.json names it, and all outcomes but the other one.
const std::vector<std::string> outcomes{"ricochet", "perforate", "stuck",
                                        "edge",     "pushed",    "other"};
// A bisection into more parts than this is a slip of the tolerance [-].
constexpr double most_parts = 1e6;

std::pair<std::string, std::string> between(const Entry &entry, const std::string &text)
{
  const auto separator = text.find(" and ");
  if (separator == std::string::npos)
    entry.fail("Two outcomes are needed, one on either side of the limit.", limit_example);
  const auto below = squeezed(text.substr(0, separator)),
             above = squeezed(text.substr(separator + 5));
  for (const auto &outcome : {below, above})
    if (std::find(outcomes.begin(), outcomes.end(), outcome) == outcomes.end())
      entry.fail(in_quotes(outcome) + " is no outcome" + guess(outcome, outcomes),
                 "Outcomes are " + joined(outcomes) + ".");
  if (below == above)
    entry.fail("Nothing lies between an outcome and itself.",
               "Name two outcomes; 'other' is all but the other one.");
  return {below, above};
}

FreeQuantity quantity_of(const Entry &entry, const std::string &text, const std::string &remedy)
{
  const auto quantity = parse_free_quantity(text);
  if (!quantity)
    entry.fail(in_quotes(text) + " is no number with a known unit.", remedy);
  return *quantity;
}

void check_combination(const Entry &entry, const StudyParameters &study)
{
  if (study.combination != Combination::all)
    entry.fail("A limit is searched for under every combination of the axes' values.",
               "Remove 'Combine'.");
  if (!study.reference.empty())
    entry.fail("A study either compares scenes or searches for a limit.", "Remove 'Reference'.");
  if (study.kind == StudyKind::convergence)
    entry.fail("A study of convergence compares the same values on all grids, and every grid would "
               "have a search of its own.",
               "Remove 'Kind', or the limit.");
}

void check_order(const LimitRows &rows, const StudyLimit &limit, const std::string &unit)
{
  if (limit.high <= limit.low)
    rows.range->fail("The range runs from its lower to its upper end.",
                     "Write '" + in_unit(limit.high, unit) + " to " + in_unit(limit.low, unit) +
                         "'.");
  const double width = limit.high - limit.low;
  if (!(limit.tolerance > width / most_parts) || limit.tolerance >= width)
    rows.tolerance->fail("The bracket must be narrower than the range, which is " +
                             in_unit(width, unit) + " wide, and more than a millionth of it.",
                         "Write for example '" + in_unit(width / 50., unit) + "'.");
}
} // namespace

std::string in_unit(const double number, const std::string &unit)
{
  return with_digits(number, 10) + (unit.empty() ? "" : " " + unit);
}

LimitRows add_limit(Section &in)
{
  const Entry &limit = in.optional(
      "Find limit", unbound_text("Section/Entry between outcome and outcome"),
      "Impact/Speed between ricochet and perforate",
      "Searches by bisection where the outcome changes, from the first outcome at the low end of "
      "the range to the second at its high end; 'other' is every outcome but the other one. Every "
      "step is a case of the study; under every combination of the axes' values");
  const Entry &range     = in.optional("Limit range", unbound_text("value to value"),
                                       "500 m/s to 900 m/s", "With a limit: where it is searched for");
  const Entry &tolerance = in.optional("Limit tolerance", unbound_text("a value with its unit"),
                                       "10 m/s", "With a limit: how wide its bracket may be");
  return {&limit, &range, &tolerance};
}

void read_limit(const LimitRows &rows, StudyParameters &study)
{
  const Entry &entry = *rows.limit;
  for (const Entry *other : {rows.range, rows.tolerance})
    if (entry.is_given() != other->is_given())
      (other->is_given() ? *other : entry)
          .fail("'Find limit', 'Limit range' and 'Limit tolerance' go together.",
                other->is_given() ? "Add '" + entry.example_line() + "'."
                                  : "Add '" + other->example_line() + "'.");
  if (!entry.is_given())
    return;
  check_combination(entry, study);
  const auto word = entry.text().find(" between ");
  if (word == std::string::npos)
    entry.fail("The word 'between' is missing.", limit_example);
  StudyLimit limit{};
  std::tie(limit.below, limit.above) = between(entry, entry.text().substr(word + 9));

  const std::string &range = rows.range->text();
  const auto to            = range.find(" to ");
  if (to == std::string::npos)
    rows.range->fail("It has no two ends.", range_example);
  const auto low  = quantity_of(*rows.range, squeezed(range.substr(0, to)), range_example),
             high = quantity_of(*rows.range, squeezed(range.substr(to + 4)), range_example),
             tolerance =
                 quantity_of(*rows.tolerance, rows.tolerance->text(), "Write it like the range.");
  for (const auto *other : {&high, &tolerance})
    if (other->dimension != low.dimension)
      (other == &high ? rows.range : rows.tolerance)
          ->fail("Its unit does not go with that of the range's low end.", range_example);
  limit.low       = low.number;
  limit.high      = high.number * (high.in_si / low.in_si);
  limit.tolerance = tolerance.number * (tolerance.in_si / low.in_si);
  check_order(rows, limit, low.unit);

  StudyAxis axis;
  axis.entries.push_back(
      parse_override(squeezed(entry.text().substr(0, word)) + "=", origin_of(entry)));
  axis.values = {in_unit(limit.low, low.unit), in_unit(limit.high, low.unit)};
  for (const auto &given : study.axes)
    for (const auto &other : given.entries)
      if (other.section == axis.entries[0].section && other.name == axis.entries[0].name)
        entry.fail("The entry is an axis of the study, too.", "Remove that axis.");
  limit.axis = study.axes.size();
  study.axes.push_back(std::move(axis));
  study.limit = limit;
}
} // namespace ricochet
