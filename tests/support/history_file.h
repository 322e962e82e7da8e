// SPDX-License-Identifier: LGPL-2.1-or-later
// Columns of a history.csv.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ricochet::tests
{
class HistoryFile
{
public:
  explicit HistoryFile(const std::filesystem::path &path)
  {
    std::ifstream file(path);
    std::string line, cell;
    while (std::getline(file, line))
    {
      if (line.empty() || line[0] == '#')
        continue;
      std::istringstream row(line);
      for (std::size_t i = 0; std::getline(row, cell, ','); ++i)
        if (names_.size() == i && rows_ == 0)
          names_.push_back(cell.substr(0, cell.find(" ["))); // without the unit
        else
          columns_[names_.at(i)].push_back(std::stod(cell));
      ++rows_;
    }
  }

  /// By its name without the unit.
  const std::vector<double> &column(const std::string &name) const
  {
    EXPECT_TRUE(columns_.count(name)) << name;
    return columns_.at(name);
  }

private:
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
  int rows_ = 0;
};
} // namespace ricochet::tests
