// SPDX-License-Identifier: LGPL-2.1-or-later
// A small HDF5 file built in memory and saved in one go: HDF5 itself never touches the disk, so a
// full disk is noticed by our own checked write and cannot damage an existing file. Numbers only;
// used by one rank.
#pragma once

#include "checkpoint_rows.h"
#include "ricochet/output/checked_file.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ricochet
{
class Hdf5File
{
public:
  /// A file in memory that holds nothing but the attribute "ricochet_version" of its root. All
  /// functions throw FileError if HDF5 reports a failure.
  Hdf5File();
  ~Hdf5File();

  /// Attribute of the root group.
  void set_attribute(const std::string &name, double value);

  /// Adds a dataset of n rows with n_columns numbers each, compressed if it is large; n_columns = 1
  /// gives a plain array. The unit becomes its attribute "unit".
  void add(const std::string &name, const std::vector<double> &values, std::size_t n_columns,
           const std::string &unit);
  void add(const std::string &name, const std::vector<float> &values, std::size_t n_columns,
           const std::string &unit);
  void add(const std::string &name, const std::vector<int> &values, std::size_t n_columns,
           const std::string &unit);

  /// Adds rows of bytes, not compressed, in the groups that its name asks for; which rows they are,
  /// of how many, and their checksum become attributes.
  void add(const std::string &name, const char *values, const Rows &rows);

  /// Adds a link, seen by readers as a group, to the root of another HDF5 file; the path is
  /// relative to this file.
  void link(const std::string &name, const std::string &file);

  /// Writes the file to disk through write_file. May be called once, last.
  void save(const std::filesystem::path &path, Durability durability = Durability::as_others);

private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};
} // namespace ricochet
