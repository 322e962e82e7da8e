// SPDX-License-Identifier: LGPL-2.1-or-later
// The time series of a run: history.csv, one line per record and complete up to the last record
// whatever happens to the run, and at the end history.h5 with the same numbers in full precision.
#pragma once

#include "ricochet/base/state_archive.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
class AppendedFile;

class History
{
public:
  /// One number per record.
  struct Column
  {
    std::string name; // without comma and slash
    std::string unit; // "-" if dimensionless
  };

  /// Creates DIRECTORY/history.csv with the header row `name [unit],name [unit],...`. The folder
  /// must exist. Collective, as all functions here; throws FileError on all ranks.
  History(MPI_Comm comm, const std::filesystem::path &directory, std::vector<Column> columns);
  ~History();

  /// Appends one record: one number per column, in the column's unit; the values of rank 0 count.
  /// The line is handed to the system at once. Throws FileError; the earlier lines stay.
  void append(const std::vector<double> &row);

  /// Saves or restores all records; history.csv is written anew then.
  void exchange_state(StateArchive &archive);

  /// Closes the text file and writes DIRECTORY/history.h5: a dataset per column with the attribute
  /// "unit". A second call does nothing. Throws FileError; history.csv stays.
  void close();

private:
  // Of rank 0.
  void begin_file();
  void append_line(const std::vector<double> &row);

  MPI_Comm comm_;
  std::filesystem::path directory_;
  std::vector<Column> columns_;
  std::vector<std::vector<double>> values_; // one vector per column
  std::unique_ptr<AppendedFile> file_;      // rank 0 only
  bool closed_ = false;
};
} // namespace ricochet
