// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/reference_data.h"

#include "commands/reference_comparison.h"
#include "support/scene_text.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

class ReferenceDataFile : public testing::Test
{
protected:
  ReferenceData read(const std::string &text) const
  {
    return read_reference_data(folder.write("exp.csv", text));
  }
  void expect_data_error(const std::string &text, const std::vector<std::string> &parts) const
  {
    expect_error([&] { read(text); }, parts);
  }

  Folder folder;
};

TEST_F(ReferenceDataFile, HasColumnsOfTheHistoryInItsUnits)
{
  const auto data = read("# X-ray pictures\n#  by A. Uthor\n"
                         "time [ms], speed [km/s], path [cm], path error [mm], kind, note\r\n"
                         "0.1, 0.5, 4.5, 2, published, first\n\n0.2,,9,,inferred,\n");
  EXPECT_EQ(data.source, (std::vector<std::string>{"X-ray pictures", "by A. Uthor"}));
  ASSERT_EQ(data.times.size(), 2u);
  EXPECT_DOUBLE_EQ(data.times[1], 200.);
  EXPECT_EQ(data.kinds, (std::vector<std::string>{"published", "inferred"}));
  ASSERT_EQ(data.columns.size(), 2u);
  EXPECT_EQ(data.columns[0].name, "speed");
  EXPECT_EQ(data.columns[0].unit, "m/s");
  EXPECT_DOUBLE_EQ(data.columns[0].values[0].value(), 500.);
  EXPECT_FALSE(data.columns[0].values[1]);
  EXPECT_DOUBLE_EQ(data.columns[1].values[1].value(), 90.);
  EXPECT_DOUBLE_EQ(data.columns[1].errors[0].value(), 2.);
  EXPECT_FALSE(data.columns[1].errors[1]);
}

TEST_F(ReferenceDataFile, WhatIsWrongIsExplained)
{
  expect_error<FileError>([&] { read_reference_data("nowhere.csv"); }, {"'nowhere.csv'"});
  expect_data_error("", {"exp.csv:0", "no header", "time [us],path [mm]"});
  expect_data_error("# source\ntime [us],path [mm]\n", {"exp.csv:2", "no row"});
  expect_data_error("path [mm]\n1\n", {"exp.csv:1", "no column 'time'"});
  expect_data_error("time [us]\n1\n", {"exp.csv:1", "besides the time"});
  expect_data_error("time [us],sped [m/s]\n1,2\n",
                    {"exp.csv:1", "'sped'", "did you mean 'speed'?", "'ricochet columns'"});
  expect_data_error("time [us],speed\n1,2\n",
                    {"exp.csv:1", "unit of the column 'speed' is missing", "'speed [m/s]'"});
  expect_data_error("time [us],speed [mm]\n1,2\n", {"exp.csv:1", "'mm' is no unit", "m/s"});
  expect_data_error("time [us],force x [N]\n1,2\n", {"exp.csv:1", "'N' is no unit", "kN"});
  expect_data_error("time [us],x [mm],x [cm]\n1,2,3\n", {"exp.csv:1", "two columns"});
  expect_data_error("time [us],x [mm],z error [mm]\n1,2,3\n",
                    {"exp.csv:1", "none of the values 'z'"});
  expect_data_error("time [us],x [mm]\n1,2\n3;4\n", {"exp.csv:3", "1 places, the header 2"});
  expect_data_error("time [us],x [mm]\n1,2\n3,4 mm\n", {"exp.csv:3", "'4 mm'", "no number"});
  expect_data_error("time [us],x [mm]\n1,2\n1,4\n", {"exp.csv:3", "does not come after"});
  expect_data_error("time [us],x [mm],x error [mm]\n1,2,-3\n", {"exp.csv:2", "negative"});
}

TEST_F(ReferenceDataFile, IsComparedAsPublishedErrorsAre)
{
  // A projectile at 1 mm/us along (3, 0, 4); 50 mm between its records.
  const auto path =
      folder.write("history.csv", "time [us],x [mm],y [mm],z [mm],speed [m/s]\n"
                                  "0,0,0,0,1000\n50,30,0,40,1000\n100,60,0,80,1000\n");
  const auto data  = read("time [us],path [mm],path error [mm],speed [m/s],kind\n"
                           "0,0,,,published\n40,50,1,1000,published\n"
                           "100,80,,,inferred\n200,90,,,inferred\n");
  const Json found = compare_with_data(std::filesystem::path(path).parent_path(), data);
  EXPECT_EQ(found["columns"][0]["name"], "path");
  const Json &points = found["columns"][0]["points"];
  ASSERT_EQ(points.size(), 4u);
  EXPECT_TRUE(points[0]["relative_error"].is_null()); // of nothing
  EXPECT_NEAR(points[1]["found"].get<double>(), 40., 1e-12);
  EXPECT_NEAR(points[1]["relative_error"].get<double>(), -0.2, 1e-12);
  EXPECT_EQ(points[1]["error_bar"], 1.);
  EXPECT_NEAR(points[2]["relative_error"].get<double>(), 0.25, 1e-12);
  EXPECT_TRUE(points[3]["found"].is_null()); // not reached
  // Of 0, -10 and +20 mm.
  EXPECT_NEAR(found["columns"][0]["rmse"].get<double>(), std::sqrt(500. / 3.), 1e-12);
  EXPECT_EQ(found["columns"][1]["rmse"], 0.);

  const Json summary{{"reference_data", found}};
  EXPECT_EQ(reference_columns(data),
            (std::vector<std::string>{
                "reference_rmse_path_mm", "reference_error_path_0_us_percent",
                "reference_error_path_40_us_percent", "reference_error_path_100_us_percent",
                "reference_error_path_200_us_percent", "reference_rmse_speed_m_s",
                "reference_error_speed_40_us_percent"}));
  EXPECT_NEAR(reference_value(summary, "reference_error_path_100_us_percent").get<double>(), 25.,
              1e-12);
  EXPECT_TRUE(reference_value(summary, "reference_error_path_200_us_percent").is_null());
  EXPECT_TRUE(reference_value(Json(), "reference_rmse_path_mm").is_null());
  const std::string text = describe_reference_data(summary);
  EXPECT_NE(text.find("path: -20.0 % at 40 us, +25.0 % at 100 us, root-mean-square error 12.91 mm "
                      "(1 of 4 times not reached)"),
            std::string::npos)
      << text;
  EXPECT_EQ(describe_reference_data(Json::object()), "");
}

TEST_F(ReferenceDataFile, OfTheProjectCanBeRead)
{
  for (const char *name : {"single_plate", "three_layers"})
  {
    const auto data =
        read_reference_data(std::string(RICOCHET_SOURCE_DIR) + "/prm/reference/" + name + ".csv");
    EXPECT_FALSE(data.source.empty());
    for (const auto &kind : data.kinds)
      EXPECT_TRUE(kind == "published" || kind == "inferred") << kind;
  }
}
} // namespace
} // namespace ricochet::tests
