// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoint_rows.h"
#include "hdf5_handle.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checkpoint_file.h"
#include "ricochet/output/collective.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace ricochet
{
namespace
{
template <class Value>
Value read_attribute(const hid_t owner, const char *const name, const hid_t type)
{
  const Handle attribute(H5Aopen(owner, name, H5P_DEFAULT), H5Aclose,
                         std::string("find the attribute ") + name);
  Value value{};
  check(H5Aread(attribute, type, &value), std::string("read the attribute ") + name);
  return value;
}

/// Of all datasets.
std::vector<std::string> names_in(const hid_t file)
{
  std::vector<std::string> names;
  const auto note = [](const hid_t group, const char *const name, const H5L_info_t *,
                       void *const list) -> herr_t
  {
    H5O_info_t info;
    if (H5Oget_info_by_name1(group, name, &info, H5P_DEFAULT) < 0)
      return -1;
    if (info.type == H5O_TYPE_DATASET)
      static_cast<std::vector<std::string> *>(list)->emplace_back(name);
    return 0;
  };
  check(H5Lvisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, note, &names), "list the datasets");
  return names;
}

/// The rows of one dataset that one file has.
class Piece
{
public:
  Piece(const hid_t file, const std::string &name) :
    dataset_(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name)
  {
    const Handle space(H5Dget_space(dataset_), H5Sclose, "ask for the shape of " + name);
    hsize_t size[2];
    check(H5Sget_simple_extent_ndims(space) == 2 ? 0 : -1, "understand " + name);
    check(H5Sget_simple_extent_dims(space, size, nullptr), "ask for the shape of " + name);
    rows_ = {size[1], read_attribute<std::uint64_t>(dataset_, first_name, H5T_NATIVE_UINT64),
             size[0], read_attribute<std::uint64_t>(dataset_, n_in_all_name, H5T_NATIVE_UINT64)};
  }

  const Rows &rows() const { return rows_; }

  /// Whether the bytes are those that were written.
  bool is_sound() const
  {
    std::vector<char> bytes(rows_.n * rows_.bytes_per_row);
    read(0, rows_.n, bytes.data());
    return checksum_of(bytes.data(), bytes.size()) ==
           read_attribute<std::uint64_t>(dataset_, checksum_name, H5T_NATIVE_UINT64);
  }

  /// Rows from `first` on, of those here.
  void read(const std::size_t first, const std::size_t n, char *const rows) const
  {
    if (n == 0 || rows_.bytes_per_row == 0)
      return;
    const hsize_t start[2] = {first, 0}, count[2] = {n, rows_.bytes_per_row};
    const Handle space(H5Dget_space(dataset_), H5Sclose, "ask for a shape"),
        memory(H5Screate_simple(2, count, nullptr), H5Sclose, "create a shape");
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr),
          "select rows");
    check(H5Dread(dataset_, H5T_NATIVE_UINT8, memory, space, H5P_DEFAULT, rows), "read rows");
  }

private:
  Handle dataset_;
  Rows rows_{};
};

[[noreturn]] void fail_to_fit(const std::filesystem::path &folder, const std::string &name)
{
  throw FileError("The checkpoint " + folder.string() + " does not fit the scene: it has no '" +
                  name +
                  "' of that size. Resume with the parameters it was written with, or start the "
                  "run anew.");
}
} // namespace

/// The files of all ranks that wrote, open on this one.
struct CheckpointReader::Files
{
  std::vector<Handle> files;

  /// Throws if some are missing or damaged; of their content each rank looks at some.
  Files(const MPI_Comm communicator, const std::filesystem::path &folder)
  {
    const auto path_of = [&](const std::size_t i)
    { return folder / ("rank_" + with_zeros(static_cast<unsigned int>(i), 4) + ".h5"); };
    const auto open = [&](const std::size_t i)
    {
      const hid_t id = H5Fopen(path_of(i).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
      if (id < 0)
        throw FileError("The checkpoint " + folder.string() + " is damaged: " +
                        path_of(i).filename().string() + " is missing or cut off.");
      files.emplace_back(id, H5Fclose, "open " + path_of(i).string());
    };
    open(0);
    const auto format = read_attribute<double>(files[0], "checkpoint_format", H5T_NATIVE_DOUBLE);
    if (format != checkpoint_format)
      throw FileError("The checkpoint " + folder.string() + " has the format " +
                      std::to_string(static_cast<int>(format)) + "; this program reads format " +
                      std::to_string(checkpoint_format) + ".");
    const auto n =
        static_cast<std::size_t>(read_attribute<double>(files[0], "ranks", H5T_NATIVE_DOUBLE));
    for (std::size_t i = 1; i < n; ++i)
      open(i);
    const auto rank = static_cast<std::size_t>(rank_in(communicator)),
               step = static_cast<std::size_t>(size_of(communicator));
    for (std::size_t i = rank; i < n; i += step)
      for (const auto &name : names_in(files[i]))
        if (!Piece(files[i], name).is_sound())
          throw FileError("The checkpoint " + folder.string() + " is damaged: '" + name +
                          "' does not match its checksum.");
  }

  bool has(const std::string &name) const
  {
    for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
      if (H5Lexists(files[0], name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        return false;
    return H5Lexists(files[0], name.c_str(), H5P_DEFAULT) > 0;
  }
  /// Of all files together.
  Rows shape(const std::string &name) const
  {
    return has(name) ? Piece(files[0], name).rows() : Rows{0, 0, 0, 0};
  }

  /// Rows first <= row < first + n.
  void read(const std::string &name, const std::size_t first, const std::size_t n,
            char *const rows) const
  {
    for (const auto &file : files)
    {
      const Piece piece(file, name);
      const auto &there      = piece.rows();
      const std::size_t from = std::max(first, there.first),
                        to   = std::min(first + n, there.first + there.n);
      if (from < to)
        piece.read(from - there.first, to - from, rows + (from - first) * there.bytes_per_row);
    }
  }
};

CheckpointReader::CheckpointReader(const MPI_Comm communicator,
                                   const std::filesystem::path &folder) :
  StateArchive(communicator),
  folder_(folder)
{
  on_every_rank(communicator,
                [&]
                {
                  const SilencedReport silenced;
                  files_ = std::make_unique<Files>(communicator, folder);
                });
  std::string program;
  common("program", program);
  if (program != version())
    throw FileError(
        "The checkpoint " + folder.string() + " was written by ricochet " + program +
        ", and this is " + version() +
        ": the run might not go on as it began. Resume with the program that wrote it.");
}

CheckpointReader::~CheckpointReader() = default;

std::size_t CheckpointReader::common_size(const std::string &name)
{
  return files_->shape(name).bytes_per_row;
}

void CheckpointReader::common_bytes(const std::string &name, char *const values,
                                    const std::size_t n)
{
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  const auto shape = files_->shape(name);
                  if (shape.n_in_all != 1 || shape.bytes_per_row != n)
                    fail_to_fit(folder_, name);
                  files_->read(name, 0, 1, values);
                });
}

void CheckpointReader::planes_bytes(const std::string &name, char *const values,
                                    const std::size_t bytes_per_plane, const PlaneShare &share)
{
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  const auto shape = files_->shape(name);
                  if (shape.n_in_all != static_cast<std::size_t>(share.n) ||
                      shape.bytes_per_row != bytes_per_plane)
                    fail_to_fit(folder_, name);
                  const int first = std::max(0, share.first_local),
                            last  = std::min(share.n, share.last_local);
                  files_->read(name, static_cast<std::size_t>(first),
                               static_cast<std::size_t>(last - first),
                               values + static_cast<std::size_t>(first - share.first_local) *
                                            bytes_per_plane);
                });
}

void CheckpointReader::rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
                               std::vector<double> &values, const std::size_t n_columns)
{
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  constexpr std::size_t at_once = 1 << 16;
                  const auto shape              = files_->shape(name);
                  if (shape.bytes_per_row != n_columns * sizeof(double))
                    fail_to_fit(folder_, name);
                  std::unordered_map<std::int64_t, std::size_t> wanted;
                  for (std::size_t i = 0; i < keys.size(); ++i)
                    wanted.emplace(keys[i], i);
                  std::size_t n_found = 0;
                  values.resize(keys.size() * n_columns);
                  for (std::size_t first = 0; first < shape.n_in_all; first += at_once)
                  {
                    const std::size_t n = std::min(at_once, shape.n_in_all - first);
                    std::vector<std::int64_t> some_keys(n);
                    std::vector<double> some(n * n_columns);
                    files_->read(name + " keys", first, n,
                                 reinterpret_cast<char *>(some_keys.data()));
                    files_->read(name, first, n, reinterpret_cast<char *>(some.data()));
                    for (std::size_t i = 0; i < n; ++i)
                      if (const auto found = wanted.find(some_keys[i]); found != wanted.end())
                      {
                        std::copy_n(some.data() + i * n_columns, n_columns,
                                    values.data() + found->second * n_columns);
                        ++n_found;
                      }
                  }
                  if (n_found != keys.size())
                    fail_to_fit(folder_, name);
                });
}
} // namespace ricochet
