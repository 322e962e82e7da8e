// SPDX-License-Identifier: LGPL-2.1-or-later
// doc/verification.md says what the tests ask, no more and no less.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace
{
namespace fs       = std::filesystem;
using Requirements = std::set<std::pair<std::string, std::string>>; // "V1", what is asked

std::string text_of(const fs::path &file)
{
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// All calls verify_...("V1", "what is asked", ...); the text may run over several literals.
Requirements asked_by_tests()
{
  const std::regex call(
      R"re(verify_(?:at_most|at_least|near)\(\s*"(V\d+)",\s*("[^"]*"(?:\s*"[^"]*")*))re"),
      joint(R"re("\s*")re");
  Requirements found;
  for (const auto &entry :
       fs::recursive_directory_iterator(fs::path(RICOCHET_SOURCE_DIR) / "tests"))
    if (entry.path().extension() == ".cc")
    {
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it)
      {
        const std::string literals = std::regex_replace((*it)[2].str(), joint, "");
        found.emplace((*it)[1], literals.substr(1, literals.size() - 2));
      }
    }
  return found;
}

Requirements told_by_page()
{
  const std::regex heading(R"re(^## (V\d+): .*)re"),
      row(R"re(^\| (.*?) \| .* \| .* \| `.*` \|$)re");
  Requirements found;
  std::ifstream in(fs::path(RICOCHET_SOURCE_DIR) / "doc" / "verification.md");
  std::string number;
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, match, heading))
      number = match[1];
    else if (std::regex_match(line, match, row))
      found.emplace(number, match[1]);
  return found;
}

TEST(Verification, PageNamesWhatTheTestsAsk)
{
  const auto asked = asked_by_tests(), told = told_by_page();
  EXPECT_GT(asked.size(), 50u) << "the tests were not found";
  for (const auto &[number, what] : asked)
    EXPECT_TRUE(told.count({number, what}))
        << number << ", " << what << ": not in doc/verification.md, which says how it is made";
  for (const auto &[number, what] : told)
    EXPECT_TRUE(asked.count({number, what})) << number << ", " << what << ": no test asks for it";
}
} // namespace
