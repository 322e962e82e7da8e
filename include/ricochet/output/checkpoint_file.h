// SPDX-License-Identifier: LGPL-2.1-or-later
// A state on disk: one HDF5 file, written and read by all ranks together. Every piece of state is a
// dataset of bytes, a row per plane, point or rank, with a checksum; what it means only the program
// that wrote it knows, hence its version stands in the file and another one does not read it.
#pragma once

#include "ricochet/base/state_archive.h"

#include <filesystem>
#include <memory>

namespace ricochet
{
/// Of the layout; goes up whenever a piece of state comes, goes or changes its meaning.
constexpr int checkpoint_format = 1;

/// Puts a state into a new file. All functions are collective and throw FileError on all ranks.
class CheckpointWriter : public StateArchive
{
public:
  /// Begins the file under a temporary name, `path` with ".tmp".
  CheckpointWriter(MPI_Comm communicator, const std::filesystem::path &path);
  /// Without commit() nothing is left on disk.
  ~CheckpointWriter() override;

  bool is_restoring() const override { return false; }

  /// The file gets its name once all of it has reached the disk. Call last.
  void commit();

private:
  struct File;

  void write(const std::string &name, const char *rows, std::size_t bytes_per_row,
             std::size_t first, std::size_t n, std::size_t n_in_all);

  void common_bytes(const std::string &name, char *values, std::size_t n) override;
  std::size_t common_size(const std::string &name) override;
  void planes_bytes(const std::string &name, char *values, std::size_t bytes_per_plane,
                    const PlaneShare &share) override;
  void rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
               std::vector<double> &values, std::size_t n_columns) override;
  void by_rank_of(const std::string &name, double *values, std::size_t n) override;

  std::filesystem::path path_;
  std::unique_ptr<File> file_;
};

/// Takes a state out of a file. All functions are collective and throw FileError on all ranks, also
/// if something is missing, has another size than asked for, or is damaged.
class CheckpointReader : public StateArchive
{
public:
  /// Reads all of it once for the checksums. Throws, too, if another version of the program has
  /// written it.
  CheckpointReader(MPI_Comm communicator, const std::filesystem::path &path);
  ~CheckpointReader() override;

  bool is_restoring() const override { return true; }

private:
  struct File;

  /// Rows first <= row < first + n.
  void read(const std::string &name, char *rows, std::size_t first, std::size_t n);
  /// Number of rows, and bytes of each.
  std::pair<std::size_t, std::size_t> shape(const std::string &name);
  void verify(const std::string &name);

  void common_bytes(const std::string &name, char *values, std::size_t n) override;
  std::size_t common_size(const std::string &name) override;
  void planes_bytes(const std::string &name, char *values, std::size_t bytes_per_plane,
                    const PlaneShare &share) override;
  void rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
               std::vector<double> &values, std::size_t n_columns) override;
  void by_rank_of(const std::string &name, double *values, std::size_t n) override;

  std::filesystem::path path_;
  std::unique_ptr<File> file_;
};
} // namespace ricochet
