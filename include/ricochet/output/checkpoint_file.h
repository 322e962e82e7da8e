// SPDX-License-Identifier: LGPL-2.1-or-later
// A state on disk: a folder with one HDF5 file per rank that wrote it. Every piece of state is a
// dataset of bytes in each of them, a row per plane, point or rank, with a checksum; what it means
// only the program that wrote it knows, hence its version stands in the files and another one does
// not read them. Any number of ranks may read.
//
// Not one file through MPI-IO: where a disk is full that leaves ranks waiting for each other.
#pragma once

#include "ricochet/base/state_archive.h"

#include <filesystem>
#include <memory>

namespace ricochet
{
class Hdf5File;

/// Of the layout; goes up whenever a piece of state comes, goes or changes its meaning.
constexpr int checkpoint_format = 1;

/// Collects a state, in memory, and writes it in the end. All functions are collective and throw
/// FileError on all ranks.
class CheckpointWriter : public StateArchive
{
public:
  /// Of all ranks that share the state.
  explicit CheckpointWriter(MPI_Comm communicator);
  ~CheckpointWriter() override;

  bool is_restoring() const override { return false; }

  /// The folder appears with all its files, once they have reached the disk, or not at all. Its
  /// parents are made if need be. Call last.
  void save(const std::filesystem::path &folder);

private:
  void common_bytes(const std::string &name, char *values, std::size_t n) override;
  std::size_t common_size(const std::string &name) override;
  void planes_bytes(const std::string &name, char *values, std::size_t bytes_per_plane,
                    const PlaneShare &share) override;
  void rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
               std::vector<double> &values, std::size_t n_columns) override;

  std::unique_ptr<Hdf5File> file_;
};

/// Takes a state out of its folder. All functions are collective and throw FileError on all ranks,
/// also if something is missing or has another size than asked for.
class CheckpointReader : public StateArchive
{
public:
  /// Reads all of it once for the checksums. Throws, too, if it is damaged or another version of
  /// the program has written it.
  CheckpointReader(MPI_Comm communicator, const std::filesystem::path &folder);
  ~CheckpointReader() override;

  bool is_restoring() const override { return true; }

private:
  struct Files;

  void common_bytes(const std::string &name, char *values, std::size_t n) override;
  std::size_t common_size(const std::string &name) override;
  void planes_bytes(const std::string &name, char *values, std::size_t bytes_per_plane,
                    const PlaneShare &share) override;
  void rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
               std::vector<double> &values, std::size_t n_columns) override;

  std::filesystem::path folder_;
  std::unique_ptr<Files> files_;
};
} // namespace ricochet
