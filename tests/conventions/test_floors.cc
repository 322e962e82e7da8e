// SPDX-License-Identifier: LGPL-2.1-or-later
// Floors look down: what a folder may include stands here as data, and nothing else is allowed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace
{
namespace fs = std::filesystem;

// Every folder may include itself and what is listed, which is the complete list: no floor is
// inherited.
const std::map<std::string, std::set<std::string>> may_include{
    {"base", {}},
    {"geometry", {"base"}},
    {"materials", {"base"}},
    {"kernels", {"materials"}},
    {"contact", {"base", "geometry"}},
    {"discretization", {"base", "geometry", "kernels", "materials"}},
    {"forces", {"base", "contact", "discretization", "geometry", "kernels", "materials"}},
    {"coupling", {"base", "discretization", "forces", "geometry"}},
    {"dynamics", {"base", "coupling", "discretization", "forces", "geometry"}},
    {"output", {"base", "discretization", "dynamics", "forces", "geometry"}},
    {"scene", {"base", "contact", "coupling", "forces", "geometry", "materials"}},
    {"drivers",
     {"base", "contact", "coupling", "discretization", "dynamics", "forces", "geometry", "kernels",
      "materials", "output", "scene"}}};

struct Include
{
  std::string file, floor, target; // target is "floor/header.h"
};

std::vector<Include> all_includes()
{
  std::vector<Include> includes;
  const std::regex pattern(R"re(^\s*#\s*include\s+"ricochet/(.+)")re");
  const fs::path root(RICOCHET_SOURCE_DIR);
  for (const fs::path &tree : {root / "include" / "ricochet", root / "source"})
    for (const auto &entry : fs::recursive_directory_iterator(tree))
    {
      if (!entry.is_regular_file() ||
          (entry.path().extension() != ".h" && entry.path().extension() != ".cc"))
        continue;
      const fs::path relative = fs::relative(entry.path(), tree);
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, match, pattern))
          includes.push_back({relative.string(), relative.begin()->string(), match[1]});
    }
  return includes;
}

TEST(Floors, LookDownOnly)
{
  const auto includes = all_includes();
  EXPECT_GT(includes.size(), 100u) << "the tree was not found";
  for (const auto &include : includes)
  {
    const std::string target = include.target.substr(0, include.target.find('/'));
    ASSERT_TRUE(may_include.count(include.floor))
        << "new floor '" << include.floor << "': give it a line in this table";
    EXPECT_TRUE(target == include.floor || may_include.at(include.floor).count(target))
        << include.file << " includes " << include.target;
  }
}

TEST(Floors, HeadersHaveNoCycles)
{
  std::map<std::string, std::set<std::string>> edges;
  for (const auto &include : all_includes())
    if (include.file.size() > 2 && include.file.substr(include.file.size() - 2) == ".h")
      edges[include.file].insert(include.target);
  // Headers whose includes are all done are removed until none is left to remove.
  for (bool removed = true; removed;)
  {
    removed = false;
    for (auto node = edges.begin(); node != edges.end();)
    {
      const bool leaf = std::none_of(node->second.begin(), node->second.end(),
                                     [&](const auto &to) { return edges.count(to); });
      node            = leaf ? edges.erase(node) : std::next(node);
      removed         = removed || leaf;
    }
  }
  std::string cycle;
  for (const auto &[file, targets] : edges)
    cycle += file + " ";
  EXPECT_TRUE(edges.empty()) << cycle;
}

TEST(Files, BeginWithTheLicence)
{
  const fs::path root(RICOCHET_SOURCE_DIR);
  int n = 0;
  for (const char *folder : {"include", "source", "tests"})
    for (const auto &entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cc")
      {
        std::ifstream in(entry.path());
        std::string line;
        std::getline(in, line);
        EXPECT_EQ(line, "// SPDX-License-Identifier: LGPL-2.1-or-later") << entry.path();
        ++n;
      }
  EXPECT_GT(n, 80);
}

/// The lines of a file that include something.
std::vector<std::pair<bool, std::string>>
includes_of(const fs::path &file) // (is a library header, name)
{
  const std::regex pattern(R"re(^\s*#\s*include\s+([<"])([^>"]+)[>"])re");
  std::vector<std::pair<bool, std::string>> includes;
  std::ifstream in(file);
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, pattern))
      includes.emplace_back(match[1] == "<", match[2]);
  return includes;
}

TEST(Files, WhatIsCompiledPerInstructionSetIncludesNoLibrary)
{
  // Inline functions of libraries, compiled for different processors, would meet in one program.
  const std::set<std::string> allowed{"emmintrin.h", "immintrin.h", "math.h", "stdint.h"}; // C only
  const fs::path root(RICOCHET_SOURCE_DIR);
  std::vector<fs::path> todo;
  for (const auto &entry : fs::recursive_directory_iterator(root / "source"))
    if (std::regex_search(entry.path().string(), std::regex("_(baseline|avx2|avx512)\\.cc$")))
      todo.push_back(entry.path());
  EXPECT_GE(todo.size(), 3u);
  std::set<fs::path> done;
  while (!todo.empty())
  {
    const fs::path file = todo.back();
    todo.pop_back();
    if (!done.insert(file).second)
      continue;
    for (const auto &[library, name] : includes_of(file))
      if (!library)
        todo.push_back(root / "include" / name);
      else
      {
        EXPECT_TRUE(allowed.count(name)) << file << " includes " << name;
      }
  }
}
} // namespace
