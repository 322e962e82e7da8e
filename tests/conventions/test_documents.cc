// SPDX-License-Identifier: LGPL-2.1-or-later
// What the documents tell a reader to type must run on the reader's machine.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace
{
namespace fs = std::filesystem;

/// All that is read and typed from: pages, parameter files, scripts, heads of measurements.
std::vector<fs::path> documents()
{
  const fs::path root(RICOCHET_SOURCE_DIR);
  std::vector<fs::path> files{root / "README.md", root / "CONTRIBUTING.md", root / "quickstart.sh"};
  for (const char *folder : {"doc", "prm", "meshes", "scripts", "tests"})
    for (const auto &entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() &&
          std::regex_search(entry.path().string(), std::regex("\\.(md|prm|sh|py|cc)$")))
        files.push_back(entry.path());
  return files;
}

TEST(Documents, MpirunIsToldThatThereMayBeFewerCoresThanProcesses)
{
  // Otherwise Open MPI refuses to start, and it counts cores, not the hardware threads of nproc.
  const std::regex several(R"re(mpirun\s.*-np\s+(?!1\b)\S)re");
  int n = 0;
  for (const auto &file : documents())
  {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, several))
      {
        ++n;
        EXPECT_NE(line.find("--oversubscribe"), std::string::npos) << file << ": " << line;
      }
  }
  EXPECT_GE(n, 4) << "the lines were not found";
}
} // namespace
