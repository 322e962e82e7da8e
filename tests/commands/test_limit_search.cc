// SPDX-License-Identifier: LGPL-2.1-or-later
#include "commands/limit_search.h"

#include "support/scene_text.h"

namespace ricochet::tests
{
namespace
{
using Json = nlohmann::ordered_json;

/// A search that asks this function how a run at a speed ends.
template <class Outcome>
LimitSearch searched(StudyParameters study, const Outcome &outcome_at)
{
  std::vector<Json> summaries;
  for (;;)
  {
    for (std::size_t i = summaries.size(); i < study.cases.size(); ++i)
      summaries.push_back({{"outcome", outcome_at(*study.cases[i].axis_values.back().number)},
                           {"failed", false},
                           {"interrupted", false}});
    const auto search = limit_searches(study, summaries).at(0);
    if (!search.next)
      return search;
    add_limit_case(study, search.like, *search.next);
  }
}

StudyParameters study_of(const Folder &folder, const std::string &between)
{
  folder.write("one.prm", scene_text);
  return read_study(folder.write("study.prm", "subsection Study\nset Scenes = one.prm\n"
                                              "set Find limit = Impact/Speed between " +
                                                  between +
                                                  "\nset Limit range = 500 m/s to 900 m/s\n"
                                                  "set Limit tolerance = 10 m/s\nend\n"));
}

TEST(LimitSearch, BracketsTheLimitWithinItsTolerance)
{
  const Folder folder;
  const auto search = searched(study_of(folder, "ricochet and perforate"), [](const double speed)
                               { return speed < 733. ? "ricochet" : "perforate"; });
  EXPECT_TRUE(search.is_found);
  // 400 m/s halved six times are 6.25 m/s, the first width below 10 m/s.
  EXPECT_DOUBLE_EQ(search.high - search.low, 6.25);
  EXPECT_LT(search.low, 733.);
  EXPECT_GE(search.high, 733.);
  EXPECT_EQ(search.n_runs, 8);
}

TEST(LimitSearch, OtherIsEveryOutcomeThatIsDecided)
{
  const Folder folder;
  const auto study = study_of(folder, "other and perforate");
  const auto found =
      searched(study,
               [](const double speed) {
                 return speed < 600. ? "ricochet" : speed < 800. ? "stuck" : "perforate";
               });
  EXPECT_TRUE(found.is_found);
  EXPECT_EQ(found.low_outcome, "stuck");
  EXPECT_EQ(found.high_outcome, "perforate");
  const auto open =
      searched(study,
               [](const double speed) {
                 return speed < 600. ? "ricochet" : speed < 800. ? "undecided" : "perforate";
               });
  EXPECT_FALSE(open.is_found);
  EXPECT_NE(open.reason.find("at 700 m/s is 'undecided'"), std::string::npos) << open.reason;
}

TEST(LimitSearch, SaysWhatStandsInItsWay)
{
  const Folder folder;
  const auto study = study_of(folder, "ricochet and perforate");
  const auto none  = searched(study, [](double) { return "ricochet"; });
  EXPECT_NE(none.reason.find("'ricochet' at 900 m/s"), std::string::npos) << none.reason;
  const auto third =
      searched(study,
               [](const double speed) {
                 return speed < 600. ? "ricochet" : speed < 800. ? "stuck" : "perforate";
               });
  EXPECT_NE(third.reason.find("neither 'ricochet' nor 'perforate'"), std::string::npos);
  EXPECT_EQ(third.low, 500.);
  EXPECT_EQ(third.high, 900.);
}
} // namespace
} // namespace ricochet::tests
