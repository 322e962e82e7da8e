// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/cost_advice.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

ComparedScene scene(const std::string &name, const Json &error, const double cost,
                    const Json &scatter)
{
  const bool is_reference = name == "full";
  return {name, "", is_reference,
          Json{{"path_error_percent", error},
               {"core_seconds", cost},
               {"cost_ratio", cost / 100.},
               {"reference_scatter_percent", scatter}}};
}

TEST(CostAdvice, NamesTheCheapestThatIsGoodEnough)
{
  const auto text = cost_advice({scene("full", 0., 100., 0.5), scene("wide", 0.4, 60., 0.5),
                                 scene("narrow", 1.5, 30., 0.5), scene("tiny", 4., 10., 0.5),
                                 scene("failed", Json(), 1., Json())});
  EXPECT_NE(text.find("Within 2 % the cheapest is narrow, with 1.5 % error of the path at 30 "
                      "core-seconds, 0.30 of the reference's cost.\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("Within 5 % the cheapest is tiny, with 4 %"), std::string::npos) << text;
  EXPECT_NE(text.find("scatter by 0.5 %: the error of wide cannot be told from none.\n"),
            std::string::npos)
      << text;
}

TEST(CostAdvice, SaysWhatTheScatterHides)
{
  const auto text =
      cost_advice({scene("full", 0., 100., 3.), scene("a", 6., 60., 3.), scene("b", 8., 30., 3.)});
  EXPECT_NE(text.find("Within 5 % there is none; the closest is a, with 6 %"), std::string::npos);
  EXPECT_NE(
      text.find("every error is larger than that; no difference can be told between b and a."),
      std::string::npos)
      << text;
  EXPECT_NE(cost_advice({scene("full", 0., 100., Json()), scene("a", 1., 60., Json())})
                .find("its scatter is unknown"),
            std::string::npos);
  EXPECT_EQ(cost_advice({scene("full", 0., 100., Json())}), "");
}
} // namespace
} // namespace ricochet::tests
