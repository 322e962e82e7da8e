// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/table.h"

#include "ricochet/base/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ricochet
{
namespace
{
using Json = nlohmann::ordered_json;

std::string cell_text(const Json &value, const bool all_digits)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_number_integer() || value.is_boolean() || (all_digits && value.is_number()))
    return value.dump();
  if (!value.is_number())
    return "-";
  return with_digits(value.get<double>(), 4);
}
} // namespace

Table::Table(const std::vector<std::string> &columns) : columns_(columns) {}
Table::Table(Table &&) noexcept = default;
Table::~Table()                 = default;

void Table::add(const std::vector<Json> &row)
{
  rows_.push_back(row);
}

std::string Table::csv() const
{
  std::string text;
  for (const auto &row : with_header(/*all_digits=*/true))
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      std::string cell = row[i];
      if (cell.find_first_of(",\"\n") != std::string::npos)
      {
        for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2)
          cell.insert(at, 1, '"');
        cell.insert(0, 1, '"');
        cell += '"';
      }
      text += i ? "," : "";
      text += cell;
    }
    text += '\n';
  }
  return text;
}

std::string Table::text() const
{
  const auto rows = with_header(/*all_digits=*/false);
  std::vector<std::size_t> width(columns_.size(), 0);
  for (const auto &row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      width[i] = std::max(width[i], row[i].size());
  std::string text;
  for (const auto &row : rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const std::string blanks(width[i] - row[i].size(), ' ');
      text += i == 0                ? row[i] + blanks
              : i + 1 == row.size() ? "  " + row[i]
                                    : "  " + blanks + row[i];
    }
    text += '\n';
  }
  return text;
}

std::vector<std::vector<std::string>> Table::with_header(const bool all_digits) const
{
  std::vector<std::vector<std::string>> rows{columns_};
  for (const auto &row : rows_)
  {
    rows.emplace_back();
    for (const auto &cell : row)
      rows.back().push_back(cell_text(cell, all_digits));
  }
  return rows;
}
} // namespace ricochet
