// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of fields of a summary: name, unit, value and meaning in one place.
#pragma once

#include "ricochet/base/units.h"
#include "ricochet/simulation/run_summary.h"

#include <utility>

namespace ricochet
{
/// The value of a field that this run does not have.
inline nlohmann::ordered_json left_out()
{
  return nlohmann::ordered_json::value_t::discarded;
}

/// Of a time [s]; negative: never.
inline nlohmann::ordered_json in_us_or_null(const double time)
{
  return time >= 0. ? nlohmann::ordered_json(time / units::us) : nullptr;
}

/// Name, unit, value and meaning of a field that is computed from a Source.
template <class Source>
struct SummaryRow
{
  const char *name, *unit;
  nlohmann::ordered_json (*value)(const Source &);
  const char *meaning;
};

/// An object with the fields that the source has.
template <class Source>
nlohmann::ordered_json object_of(const std::vector<SummaryRow<Source>> &rows, const Source &source,
                                 const std::string &prefix = "")
{
  nlohmann::ordered_json object;
  for (const auto &row : rows)
    if (auto value = row.value(source); !value.is_discarded())
      object[prefix + row.name] = std::move(value);
  return object;
}

/// Says what the rows are, for the user.
template <class Source>
void append(std::vector<SummaryField> &fields, const std::string &place,
            const std::vector<SummaryRow<Source>> &rows)
{
  for (const auto &row : rows)
    fields.push_back({place, row.name, row.unit, row.meaning});
}
} // namespace ricochet
