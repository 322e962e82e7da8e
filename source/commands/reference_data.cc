// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_data.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/scene/quantity.h"
#include "ricochet/scene/text_tools.h"
#include "ricochet/simulation/history_record.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace ricochet
{
namespace
{
using Column = ReferenceData::Column;

const char *const header_example = "time [us],path [mm],path error [mm],kind";
const std::string error_ending   = " error";

/// A column as the file has it.
struct FileColumn
{
  enum class Kind
  {
    time,
    value,
    error, // of another column
    kind,
    note
  };
  Kind kind;
  std::string name;    // without " error"
  std::string unit;    // of the history
  double factor = 1.;  // from the file's unit to it
  std::size_t place{}; // of its column in the data
};

bool ends_with(const std::string &text, const std::string &ending)
{
  return text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

class Reader
{
public:
  explicit Reader(const std::string &path) : in_(path) { data_.path = path; }

  ReferenceData operator()()
  {
    if (!in_)
      throw FileError("The reference data " + in_quotes(data_.path) +
                      " cannot be read. Is the name right? It is relative to the parameter file "
                      "that gives it.");
    for (std::string line; std::getline(in_, line);)
    {
      ++line_;
      const std::string text = squeezed(line); // also without the end of a Windows line
      if (!text.empty() && text[0] == '#')
        data_.source.push_back(squeezed(text.substr(1)));
      else if (!text.empty())
        columns_.empty() ? read_header(split(text, ',')) : read_row(split(text, ','));
    }
    if (columns_.empty())
      fail("There is no header.",
           std::string("Begin with a line such as '") + header_example + "'.");
    if (data_.times.empty())
      fail("There is no row of numbers.", "Add at least one time.");
    return std::move(data_);
  }

private:
  [[noreturn]] void fail(const std::string &what, const std::string &remedy) const
  {
    throw InputError(data_.path + ":" + std::to_string(line_) + ": " + what + "\n  " + remedy);
  }

  void read_header(const std::vector<std::string> &cells)
  {
    for (const auto &cell : cells)
      columns_.push_back(column_of(cell));
    const auto count = [&](const FileColumn::Kind kind, const std::string &name)
    {
      return std::count_if(columns_.begin(), columns_.end(),
                           [&](const auto &c) { return c.kind == kind && c.name == name; });
    };
    for (std::size_t i = 0; i < columns_.size(); ++i)
    {
      auto &column = columns_[i];
      if (count(column.kind, column.name) > 1)
        fail("There are two columns " + in_quotes(cells[i]) + ".", "Remove one of them.");
      if (column.kind == FileColumn::Kind::error && !count(FileColumn::Kind::value, column.name))
        fail("There is a column " + in_quotes(cells[i]) + ", but none of the values " +
                 in_quotes(column.name) + ".",
             "Add that column, or remove the errors.");
      if (column.kind == FileColumn::Kind::value)
      {
        column.place = data_.columns.size();
        data_.columns.push_back({column.name, column.unit, {}, {}});
      }
    }
    for (auto &column : columns_)
      if (column.kind == FileColumn::Kind::error)
        while (data_.columns[column.place].name != column.name)
          ++column.place;
    if (!count(FileColumn::Kind::time, "time"))
      fail("There is no column 'time'.",
           std::string("Write a header such as '") + header_example + "'.");
    if (data_.columns.empty())
      fail("There is no column besides the time.",
           std::string("Write a header such as '") + header_example + "'.");
  }

  FileColumn column_of(const std::string &cell) const
  {
    if (cell == "kind" || cell == "note")
      return {cell == "kind" ? FileColumn::Kind::kind : FileColumn::Kind::note, cell, ""};
    const auto bracket     = cell.find('[');
    const std::string name = squeezed(cell.substr(0, bracket));
    FileColumn column{FileColumn::Kind::value, name, ""};
    std::vector<std::string> names{path_column};
    for (const auto &known : history_columns())
      names.push_back(known.name);
    const auto is_known = [&](const std::string &text)
    { return std::find(names.begin(), names.end(), text) != names.end(); };
    if (name == "time")
      column.kind = FileColumn::Kind::time;
    else if (!is_known(name) && ends_with(name, error_ending))
    {
      column.kind = FileColumn::Kind::error;
      column.name = name.substr(0, name.size() - error_ending.size());
    }
    if (!is_known(column.name))
      fail("The history has no column " + in_quotes(column.name) + guess(column.name, names),
           "Use a name that 'ricochet columns' prints for history.csv, or 'path', 'kind', 'note'.");
    column.unit = column.name == path_column ? "mm" : unit_of(column.name);
    if (bracket == std::string::npos || cell.back() != ']')
      fail("The unit of the column " + in_quotes(cell) + " is missing.",
           "Write it in brackets: '" + name + " [" + column.unit + "]'.");
    column.factor = factor(squeezed(cell.substr(bracket + 1, cell.size() - bracket - 2)), column);
    return column;
  }

  static std::string unit_of(const std::string &name)
  {
    for (const auto &known : history_columns())
      if (known.name == name)
        return known.unit;
    return "";
  }

  double factor(const std::string &unit, const FileColumn &column) const
  {
    if (unit == column.unit)
      return 1.;
    const auto given  = parse_free_quantity("1 " + unit),
               wanted = parse_free_quantity("1 " + column.unit);
    if (!given || !wanted || given->dimension != wanted->dimension || unit.empty())
      fail(in_quotes(unit) + " is no unit of the column " + in_quotes(column.name) + ".",
           "Give it in " + column.unit + (wanted ? ", or in a unit that converts to it." : "."));
    return given->in_si / wanted->in_si;
  }

  void read_row(const std::vector<std::string> &cells)
  {
    if (cells.size() != columns_.size())
      fail("The row has " + std::to_string(cells.size()) + " places, the header " +
               std::to_string(columns_.size()) + ".",
           "Separate them by commas; leave a place empty where nothing is known.");
    for (auto &column : data_.columns)
    {
      column.values.emplace_back();
      column.errors.emplace_back();
    }
    data_.kinds.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i)
      read_cell(columns_[i], cells[i]);
  }

  void read_cell(const FileColumn &column, const std::string &cell)
  {
    switch (column.kind)
    {
      case FileColumn::Kind::note:
        return;
      case FileColumn::Kind::kind:
        data_.kinds.back() = cell;
        return;
      case FileColumn::Kind::time:
        data_.times.push_back(column.factor * number(cell, column));
        if (data_.times.size() > 1 && !(data_.times.back() > data_.times.end()[-2]))
          fail("The time " + in_quotes(cell) + " does not come after the one before.",
               "Sort the rows by time, each time once.");
        return;
      case FileColumn::Kind::value:
        if (!cell.empty())
          data_.columns[column.place].values.back() = column.factor * number(cell, column);
        return;
      case FileColumn::Kind::error:
        if (cell.empty())
          return;
        auto &error = data_.columns[column.place].errors.back();
        error       = column.factor * number(cell, column);
        if (*error < 0.)
          fail("The error " + in_quotes(cell) + " is negative.",
               "Give half the length of the error bar.");
        return;
    }
  }

  double number(const std::string &cell, const FileColumn &column) const
  {
    double value           = 0.;
    const char *const end  = cell.data() + cell.size();
    const std::size_t skip = !cell.empty() && cell[0] == '+';
    const auto result      = std::from_chars(cell.data() + skip, end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
      fail(in_quotes(cell) + " in the column " + in_quotes(column.name) + " is no number.",
           "Write numbers with a point as decimal mark; units stand in the header.");
    return value;
  }

  std::ifstream in_;
  int line_ = 0;
  ReferenceData data_;
  std::vector<FileColumn> columns_; // empty until the header has been read
};
} // namespace

ReferenceData read_reference_data(const std::string &path)
{
  return Reader(path)();
}

std::optional<ReferenceData> reference_data_of(const Scene &scene)
{
  if (scene.output.reference_data.empty())
    return {};
  return read_reference_data(scene.output.reference_data);
}
} // namespace ricochet
