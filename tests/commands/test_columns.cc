// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/columns.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace ricochet
{
namespace
{
TEST(Columns, JsonExplainsHistorySummaryAndFrames)
{
  std::ostringstream text;
  print_columns(text, /*json=*/true);
  const auto all  = nlohmann::json::parse(text.str());
  const auto find = [&](const char *list, const char *name)
  {
    const auto found =
        std::find_if(all[list].begin(), all[list].end(),
                     [&](const nlohmann::json &entry) { return entry["name"] == name; });
    return found == all[list].end() ? nlohmann::json::object() : *found;
  };
  EXPECT_EQ(find("history", "energy fracture").value("unit", ""), "J");
  EXPECT_EQ(find("summary", "exit_speed_m_s").value("unit", ""), "m/s");
  EXPECT_EQ(find("summary", "plate_N_front_damaged_mm2").value("unit", ""), "mm2");
  EXPECT_EQ(find("summary", "zones[].step_limit_us").value("unit", ""), "us");
  EXPECT_EQ(find("summary", "positions[].x_mm").value("unit", ""), "mm");
  EXPECT_EQ(find("frames", "von Mises stress").value("unit", ""), "Pa");
  for (const char *list : {"history", "summary", "frames"})
    for (const auto &entry : all[list])
      EXPECT_FALSE(entry["meaning"].get<std::string>().empty()) << entry;
}

TEST(Columns, TableHasALineForEach)
{
  std::ostringstream text, json;
  print_columns(text, /*json=*/false);
  print_columns(json, /*json=*/true);
  const auto all    = nlohmann::json::parse(json.str());
  const auto table  = text.str();
  const auto n_rows = std::count(table.begin(), table.end(), '\n');
  EXPECT_EQ(n_rows, static_cast<long>(all["history"].size() + all["summary"].size() +
                                      all["frames"].size()) +
                        5); // three heads and two gaps
}
} // namespace
} // namespace ricochet
