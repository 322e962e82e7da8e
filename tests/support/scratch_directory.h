// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder of one test, the same on all ranks, removed at its end; and small helpers to look into
// files.
#pragma once

#include "ricochet/base/exceptions.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <mpi.h>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace ricochet::tests
{
inline int rank()
{
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

inline int n_ranks()
{
  int result = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &result);
  return result;
}

class ScratchDirectory
{
public:
  ScratchDirectory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "ricochet_test_XXXXXX").string();
    if (rank() == 0 && !mkdtemp(name.data()))
      std::abort();
    MPI_Bcast(name.data(), static_cast<int>(name.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
    path_ = name;
  }
  ~ScratchDirectory()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (rank() == 0)
      std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory &)            = delete;
  ScratchDirectory &operator=(const ScratchDirectory &) = delete;

  const std::filesystem::path &path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// While it lives no file may grow beyond a size on this process, as on a full disk.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(const rlim_t bytes)
  {
    handler_ = std::signal(SIGXFSZ, SIG_IGN); // an error code instead of the end of the process
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit()
  {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit &)            = delete;
  FileSizeLimit &operator=(const FileSizeLimit &) = delete;

private:
  rlimit before_{};
  void (*handler_)(int);
};

/// The message of the FileError that the action throws; fails the test if it throws none.
inline std::string message_of(const std::function<void()> &action)
{
  try
  {
    action();
  }
  catch (const FileError &error)
  {
    return error.what();
  }
  ADD_FAILURE() << "no FileError was thrown";
  return "";
}

inline bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

inline std::string read_text(const std::filesystem::path &path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(file.good()) << path;
  return text.str();
}

inline std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

struct Dataset
{
  std::vector<hsize_t> shape;
  std::vector<double> values;
  std::string unit;
};

/// Reads a dataset by its path inside the file, through links to other files as well.
inline Dataset read_dataset(const std::filesystem::path &file, const std::string &name)
{
  Dataset result;
  const hid_t id      = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(id, name.c_str(), H5P_DEFAULT);
  EXPECT_GE(dataset, 0) << file << " " << name;
  if (dataset < 0)
    return result;
  const hid_t space = H5Dget_space(dataset);
  result.shape.resize(H5Sget_simple_extent_ndims(space));
  H5Sget_simple_extent_dims(space, result.shape.data(), nullptr);
  result.values.resize(H5Sget_simple_extent_npoints(space));
  const herr_t status =
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data());
  EXPECT_TRUE(status >= 0 || result.values.empty()) << file << " " << name;
  const hid_t attribute = H5Aopen(dataset, "unit", H5P_DEFAULT);
  const hid_t type      = H5Aget_type(attribute);
  result.unit.resize(H5Tget_size(type));
  EXPECT_GE(H5Aread(attribute, type, result.unit.data()), 0);
  H5Tclose(type);
  H5Aclose(attribute);
  H5Sclose(space);
  H5Dclose(dataset);
  H5Fclose(id);
  return result;
}

/// Reads a number that is an attribute of a group.
inline double read_attribute(const std::filesystem::path &file, const std::string &group,
                             const std::string &name)
{
  double value   = 0.;
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute =
      H5Aopen_by_name(id, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(attribute, 0) << file << " " << group;
  EXPECT_GE(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), 0);
  H5Aclose(attribute);
  H5Fclose(id);
  return value;
}
} // namespace ricochet::tests
