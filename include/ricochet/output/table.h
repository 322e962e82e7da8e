// SPDX-License-Identifier: LGPL-2.1-or-later
// A table of results, for the eye and as CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace ricochet
{
class Table
{
public:
  /// Without rows; `columns` are the heads.
  explicit Table(const std::vector<std::string> &columns);
  Table(Table &&) noexcept; // tables move
  ~Table();

  /// One value per column; null is an empty place.
  void add(const std::vector<nlohmann::ordered_json> &row);

  /// All digits; empty places are "-".
  std::string csv() const;

  /// Four digits, columns aligned: the first and the last one to the left, the others to the right.
  std::string text() const;

private:
  std::vector<std::vector<std::string>> with_header(bool all_digits) const;

  std::vector<std::string> columns_;
  std::vector<std::vector<nlohmann::ordered_json>> rows_;
};
} // namespace ricochet
