// SPDX-License-Identifier: LGPL-2.1-or-later
// Rooms look down: what a room may include is what its CMake target links, and nothing else is
// allowed. CMake writes the list (floors.txt), so a room cannot say one thing and do another.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace
{
namespace fs = std::filesystem;

struct Room
{
  std::string name;
  std::set<std::string> depends;
};

/// From the ground up, as CMake knows them.
std::vector<Room> all_rooms()
{
  std::vector<Room> rooms;
  std::ifstream in(fs::path(RICOCHET_BINARY_DIR) / "floors.txt");
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    Room room;
    words >> room.name;
    room.name.pop_back(); // the colon
    for (std::string other; words >> other;)
      room.depends.insert(other);
    rooms.push_back(room);
  }
  return rooms;
}

struct Include
{
  std::string file, room, target; // file is "room/name", target is "room/header.h"
  bool is_public;                 // the target
};

/// All includes of the project's own headers. A private header is included by its name alone.
std::vector<Include> all_includes()
{
  std::vector<Include> includes;
  const std::regex pattern(R"re(^\s*#\s*include\s+"(.+)")re");
  const fs::path root(RICOCHET_SOURCE_DIR);
  for (const fs::path &tree : {root / "include" / "ricochet", root / "source"})
    for (const auto &entry : fs::recursive_directory_iterator(tree))
    {
      if (!entry.is_regular_file() ||
          (entry.path().extension() != ".h" && entry.path().extension() != ".cc"))
        continue;
      const fs::path relative = fs::relative(entry.path(), tree);
      const std::string room  = relative.begin()->string();
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, match, pattern))
        {
          const std::string name = match[1];
          const bool is_public   = name.rfind("ricochet/", 0) == 0;
          includes.push_back(
              {relative.string(), room, is_public ? name.substr(9) : room + "/" + name, is_public});
        }
    }
  return includes;
}

std::string room_of(const std::string &file)
{
  return file.substr(0, file.find('/'));
}

TEST(Rooms, LookDownOnly)
{
  const auto rooms = all_rooms();
  ASSERT_GT(rooms.size(), 10u) << "floors.txt was not found";
  std::set<std::string> below;
  std::size_t arrows = 0;
  for (const auto &room : rooms)
  {
    for (const auto &other : room.depends)
      EXPECT_TRUE(below.count(other)) << room.name << " looks up at " << other;
    arrows += room.depends.size();
    below.insert(room.name);
  }
  const std::size_t possible = rooms.size() * (rooms.size() - 1) / 2;
  std::cout << arrows << " of " << possible << " possible arrows between rooms\n";
  EXPECT_LT(2 * arrows, possible);
}

TEST(Rooms, IncludeWhatTheirTargetsLink)
{
  std::map<std::string, std::set<std::string>> may_include, does_include;
  for (const auto &room : all_rooms())
    may_include[room.name] = room.depends;
  const auto includes = all_includes();
  EXPECT_GT(includes.size(), 100u) << "the tree was not found";
  for (const auto &include : includes)
  {
    ASSERT_TRUE(may_include.count(include.room))
        << "new folder '" << include.room << "': make it a room in source/CMakeLists.txt";
    const std::string target = room_of(include.target);
    EXPECT_TRUE(target == include.room || may_include.at(include.room).count(target))
        << include.file << " includes " << include.target;
    does_include[include.room].insert(target);
  }
  for (const auto &[room, others] : may_include)
    for (const auto &other : others)
      EXPECT_TRUE(does_include[room].count(other)) << room << " links " << other << " in vain";
}

TEST(Rooms, TheTwoWingsDoNotKnowEachOther)
{
  for (const auto &room : all_rooms())
  {
    EXPECT_FALSE(room.name == "peridynamics" && room.depends.count("finite_elements"));
    EXPECT_FALSE(room.name == "finite_elements" && room.depends.count("peridynamics"));
  }
}

TEST(Rooms, HaveInIncludeWhatOthersUse)
{
  const fs::path root(RICOCHET_SOURCE_DIR);
  // Public is what another room includes, and what that needs.
  std::map<std::string, std::set<std::string>> users, needs;
  for (const auto &include : all_includes())
  {
    users[include.target].insert(include.room);
    needs[include.file].insert(include.target);
    const fs::path file = include.is_public ? root / "include/ricochet" / include.target
                                            : root / "source" / include.target;
    EXPECT_TRUE(fs::exists(file)) << include.file << " includes " << include.target;
  }
  std::set<std::string> used;
  std::vector<std::string> todo;
  for (const auto &[header, rooms] : users)
    for (const auto &room : rooms)
      if (room != room_of(header))
        todo.push_back(header);
  while (!todo.empty())
  {
    const std::string header = todo.back();
    todo.pop_back();
    if (used.insert(header).second)
      todo.insert(todo.end(), needs[header].begin(), needs[header].end());
  }
  for (const auto &entry : fs::recursive_directory_iterator(root / "include" / "ricochet"))
    if (entry.is_regular_file())
    {
      const std::string header = fs::relative(entry.path(), root / "include/ricochet").string();
      // The topmost room is what a program that uses the library includes.
      EXPECT_TRUE(used.count(header) || room_of(header) == "simulation")
          << header << " has no user in another room: it belongs beside its sources";
    }
}

TEST(Rooms, HeadersHaveNoCycles)
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
        todo.push_back(name.rfind("ricochet/", 0) == 0 ? root / "include" / name
                                                       : file.parent_path() / name);
      else
      {
        EXPECT_TRUE(allowed.count(name)) << file << " includes " << name;
      }
  }
}
} // namespace
