// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_axis.h"

#include "ricochet/base/number_text.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/text_tools.h"

#include <algorithm>
#include <cmath>

namespace ricochet
{
namespace
{
const char *const example       = "Write 'Section/Entry: value | value', for example 'Plate 1/Grid "
                                  "spacing: 1.5 mm | 1.0 mm'.";
const char *const range_example = "Write ranges like '500 m/s to 900 m/s step 50 m/s'.";
// More runs than this are a slip of the step, not a study [-].
constexpr double most_members   = 1000.;
// Rounding of decimal fractions, as a share of a step [-].
constexpr double rounding       = 1e-6;

/// The text of a number and the unit behind it.
std::string quantity_text(const double number, const std::string &unit)
{
  return with_digits(number, 12) + (unit.empty() ? "" : " " + unit);
}

/// The members of "first to last step step", in the unit of the first.
std::vector<std::string> members(const Entry &entry, const std::string &range,
                                 const std::string &first_text, const std::string &last_text,
                                 const std::string &step_text)
{
  const auto first = parse_free_quantity(first_text), last = parse_free_quantity(last_text),
             step = parse_free_quantity(step_text);
  for (const auto &[part, text] :
       {std::make_pair(&first, &first_text), std::make_pair(&last, &last_text),
        std::make_pair(&step, &step_text)})
  {
    if (!*part)
      entry.fail(in_quotes(*text) + " in the range " + in_quotes(range) +
                     " is no number with a known unit.",
                 range_example);
    if ((*part)->dimension != first->dimension)
      entry.fail("The range " + in_quotes(range) + " mixes units that do not go together.",
                 range_example);
  }
  const auto in_unit  = [&](const FreeQuantity &q) { return q.number * (q.in_si / first->in_si); };
  const double length = in_unit(*last) - first->number, width = in_unit(*step);
  const double n = std::round(length / width);
  if (!(n >= 1.) || n >= most_members)
    entry.fail("The step of the range " + in_quotes(range) +
                   " must lead from the first value to the last in at least one and less than " +
                   number_text(most_members) + " steps.",
               range_example);
  if (std::abs(length - n * width) > rounding * std::abs(width))
    entry.fail("The step of the range " + in_quotes(range) + " does not meet its last value.",
               "End at " +
                   quantity_text(first->number + std::floor(length / width) * width, first->unit) +
                   ", or choose another step.");
  std::vector<std::string> values;
  for (int i = 0; i <= static_cast<int>(n); ++i)
    values.push_back(quantity_text(first->number + i * (length / n), first->unit));
  return values;
}

std::vector<std::string> expanded(const Entry &entry, const std::string &value)
{
  const auto to = value.find(" to "), step = value.find(" step ");
  if (to == std::string::npos && step == std::string::npos)
    return {value};
  if (to == std::string::npos || step == std::string::npos || step < to)
    entry.fail(in_quotes(value) + " is neither a value nor a complete range.", range_example);
  return members(entry, value, squeezed(value.substr(0, to)),
                 squeezed(value.substr(to + 4, step - to - 4)), squeezed(value.substr(step + 6)));
}

void check_values(const Entry &entry, const StudyAxis &axis)
{
  const auto &values = axis.values;
  for (auto value = values.begin(); value != values.end(); ++value)
  {
    if (value->empty())
      entry.fail("A value is missing.", example);
    if (std::find(values.begin(), value, *value) != value)
      entry.fail("The value " + in_quotes(*value) + " stands there twice.", "Remove one of them.");
    if (const auto n = split(*value, ';').size(); n != 1 && n != axis.entries.size())
      entry.fail(in_quotes(*value) + " gives " + std::to_string(n) + " values to " +
                     std::to_string(axis.entries.size()) + " entries.",
                 "Write one value for all entries, or one for each with ';' between them.");
  }
}

/// The values of one entry of an axis; those of the first also where they are common to all.
std::vector<std::string> values_of(const StudyAxis &axis, const std::size_t entry)
{
  std::vector<std::string> values;
  for (const auto &value : axis.values)
  {
    const auto parts = split(value, ';');
    values.push_back(parts[parts.size() == 1 ? 0 : entry]);
  }
  return values;
}

/// The unit of the first value if all of them are numbers of its dimension, and whether they are.
std::pair<std::string, bool> common_unit(const std::vector<std::string> &values)
{
  const auto first = parse_free_quantity(values.front());
  for (const auto &value : values)
    if (const auto other = parse_free_quantity(value);
        !first || !other || other->dimension != first->dimension)
      return {"", false};
  return {first->unit, true};
}
/// What stands behind the ':'.
std::string values_text(const Entry &entry)
{
  return squeezed(entry.text().substr(entry.text().find(':') + 1));
}

std::vector<ParameterEntry> entries_of(const Entry &entry)
{
  const std::string &text = entry.text();
  const auto colon        = text.find(':');
  if (colon == std::string::npos)
    entry.fail("No ':' separates the entry from its values.", example);
  std::vector<ParameterEntry> entries;
  for (const auto &path : split(text.substr(0, colon), ','))
  {
    if (path.empty())
      entry.fail("The name of an entry is missing.", example);
    entries.push_back(parse_override(path + "=", origin_of(entry)));
  }
  return entries;
}

/// Which axis, and by how much its values are multiplied.
struct Derivation
{
  std::size_t axis;
  double factor;
};

Derivation derivation(const Entry &entry, const Entries &rows)
{
  const std::string text  = squeezed(values_text(entry).substr(1));
  const auto sign         = text.find_first_of("*/");
  const std::string front = squeezed(text.substr(0, sign)),
                    back  = sign == std::string::npos ? "1" : squeezed(text.substr(sign + 1));
  const bool divides      = sign != std::string::npos && text[sign] == '/';
  for (std::size_t a = 0; a < rows.size(); ++a)
    for (const auto &[name, other] : {std::make_pair(front, back), std::make_pair(back, front)})
      if (const auto factor = parse_free_quantity(other);
          name == rows[a]->name && factor && factor->unit.empty() && factor->number != 0. &&
          !(divides && name == back))
        return {a, divides ? 1. / factor->number : factor->number};
  entry.fail(in_quotes(values_text(entry)) + " does not follow from an axis that has values.",
             "Write '= 4 * Axis 1', '= Axis 1 / 2' or '= Axis 1', with a number and an axis of "
             "this study that is not derived itself.");
}
} // namespace

bool is_derived(const Entry &entry)
{
  const auto colon = entry.text().find(':');
  return colon != std::string::npos && values_text(entry).rfind('=', 0) == 0;
}

void derive_axis(const Entry &entry, const Entries &rows, std::vector<StudyAxis> &axes)
{
  const auto [number, factor] = derivation(entry, rows);
  const auto entries          = entries_of(entry);
  StudyAxis &axis             = axes[number];
  for (auto &value : axis.values)
  {
    auto parts       = split(value, ';');
    const auto first = parse_free_quantity(parts.front());
    if (!first)
      entry.fail("The value " + in_quotes(value) + " of " + in_quotes(rows[number]->name) +
                     " is no number with a known unit, and cannot be multiplied.",
                 "Write the values out: 'value | value'.");
    parts.resize(axis.entries.size(), parts.front()); // one for all becomes one for each
    parts.insert(parts.end(), entries.size(), quantity_text(first->number * factor, first->unit));
    value.clear();
    for (const auto &part : parts)
      value += (value.empty() ? "" : "; ") + part;
  }
  axis.entries.insert(axis.entries.end(), entries.begin(), entries.end());
}

std::string origin_of(const Entry &entry)
{
  return entry.origin() + " (" + entry.name + ")";
}

StudyAxis read_axis(const Entry &entry)
{
  StudyAxis axis;
  axis.entries = entries_of(entry);
  for (const auto &value : split(values_text(entry), '|'))
    for (auto &member : expanded(entry, value))
      axis.values.push_back(std::move(member));
  check_values(entry, axis);
  return axis;
}

std::vector<AxisColumn> columns_of(const std::vector<StudyAxis> &axes)
{
  std::vector<AxisColumn> columns;
  for (const auto &axis : axes)
  {
    const bool is_common =
        std::all_of(axis.values.begin(), axis.values.end(),
                    [](const auto &value) { return split(value, ';').size() == 1; });
    for (std::size_t e = 0; e < (is_common ? 1 : axis.entries.size()); ++e)
    {
      const auto [unit, is_number] = common_unit(values_of(axis, e));
      columns.push_back({{"", lower_case(axis.entries[e].name), unit, is_number}, axis.entries[e]});
    }
  }
  const auto is_shared = [&, labels = columns](const std::string &label)
  {
    return std::count_if(labels.begin(), labels.end(),
                         [&](const auto &other) { return other.column.label == label; }) > 1;
  };
  for (auto &[column, entry] : columns)
  {
    if (is_shared(column.label))
      column.label = lower_case(entry.section) + " " + column.label;
    std::string name = column.label + (column.unit.empty() ? "" : " " + column.unit);
    name.erase(std::remove(name.begin(), name.end(), '\''), name.end());
    column.name = file_name_of(name);
  }
  return columns;
}

AxisValue value_in(const StudyColumn &column, const std::string &text)
{
  if (const auto quantity = parse_free_quantity(text); column.is_number && quantity)
    if (const auto unit = parse_free_quantity("1 " + column.unit);
        unit && unit->dimension == quantity->dimension)
      return {text, unit->unit == quantity->unit
                        ? quantity->number
                        : quantity->number * (quantity->in_si / unit->in_si)};
  return {text, {}};
}
} // namespace ricochet
