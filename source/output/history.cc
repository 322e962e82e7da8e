// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/history.h"

#include "hdf5_file.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"

#include <cassert>
#include <utility>

namespace ricochet
{
History::History(const MPI_Comm comm, const std::filesystem::path &directory,
                 std::vector<Column> columns) :
  comm_(comm),
  directory_(directory), columns_(std::move(columns)), values_(columns_.size())
{
  on_first_rank(comm_, [&] { begin_file(); });
}

History::~History() = default;

void History::begin_file()
{
  std::string header;
  for (const Column &column : columns_)
    header += (header.empty() ? "" : ",") + column.name + " [" + column.unit + "]";
  file_ = std::make_unique<AppendedFile>(directory_ / "history.csv");
  file_->append(header + "\n");
}

void History::append_line(const std::vector<double> &row)
{
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i)
    line += (i == 0 ? "" : ",") + with_digits(row[i], 10);
  file_->append(line + "\n");
}

void History::append(const std::vector<double> &row)
{
  assert(!closed_ && row.size() == columns_.size());
  on_first_rank(comm_, [&] { append_line(row); });
  for (std::size_t i = 0; i < row.size(); ++i)
    values_[i].push_back(row[i]);
}

void History::exchange_state(StateArchive &archive)
{
  const StateArchive::Group group(archive, "history");
  for (std::size_t i = 0; i < columns_.size(); ++i)
    archive.common(columns_[i].name, values_[i]);
  if (!archive.is_restoring())
    return;
  on_first_rank(comm_,
                [&]
                {
                  begin_file();
                  std::vector<double> row(columns_.size());
                  for (std::size_t record = 0; record < values_.front().size(); ++record)
                  {
                    for (std::size_t i = 0; i < row.size(); ++i)
                      row[i] = values_[i].at(record);
                    append_line(row);
                  }
                });
}

void History::close()
{
  if (closed_)
    return;
  closed_ = true;
  on_first_rank(comm_,
                [&]
                {
                  file_->close();
                  Hdf5File file;
                  for (std::size_t i = 0; i < columns_.size(); ++i)
                    file.add(columns_[i].name, values_[i], 1, columns_[i].unit);
                  file.save(directory_ / "history.h5");
                });
}
} // namespace ricochet
