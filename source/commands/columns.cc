// SPDX-License-Identifier: LGPL-2.1-or-later
#include "columns.h"

#include "ricochet/output/frame_fields.h"
#include "ricochet/output/table.h"
#include "ricochet/simulation/run_summary.h"

#include <ostream>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

/// Where a field stands: "zones[].elements", "plate_N_broken_share".
std::string full_name(const SummaryField &field)
{
  if (field.place == "reference_data")
    return field.place + "." + field.name + "[]";
  const bool is_list = !field.place.empty() && field.place.back() != '_';
  return field.place + (is_list ? "[]." : "") + field.name;
}
} // namespace

void print_columns(std::ostream &out, const bool json)
{
  Json all{{"history", Json::array()}, {"summary", Json::array()}, {"frames", Json::array()}};
  Table history({"history.csv", "unit", "meaning"}), summary({"summary.json", "unit", "meaning"}),
      frames({"results.pvd", "unit", "meaning"});
  for (const auto &column : history_columns())
  {
    all["history"].push_back(
        {{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
    history.add({column.name, column.unit, column.meaning});
  }
  for (const auto &field : summary_fields())
  {
    all["summary"].push_back(
        {{"name", full_name(field)}, {"unit", field.unit}, {"meaning", field.meaning}});
    summary.add({full_name(field), field.unit, field.meaning});
  }
  for (const auto &field : frame_fields())
  {
    all["frames"].push_back(
        {{"name", field.name}, {"unit", field.unit}, {"meaning", field.meaning}});
    frames.add({field.name, field.unit, field.meaning});
  }
  if (json)
    out << all.dump(2) << "\n";
  else
    out << history.text() << "\n" << summary.text() << "\n" << frames.text();
}
} // namespace ricochet
