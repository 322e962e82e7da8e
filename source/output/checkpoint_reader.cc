// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoint_rows.h"
#include "ricochet/base/mpi_tools.h"
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
  const SilencedReport silenced;
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
} // namespace

struct CheckpointReader::File
{
  Handle id;
};

CheckpointReader::CheckpointReader(const MPI_Comm communicator, const std::filesystem::path &path) :
  StateArchive(communicator), path_(path)
{
  on_every_rank(communicator,
                [&]
                {
                  const SilencedReport silenced;
                  const Handle access = file_access(communicator);
                  const hid_t id      = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
                  if (id < 0)
                    throw FileError("The checkpoint " + path.string() +
                                    " is missing or damaged. Resume from another one.");
                  file_.reset(new File{Handle(id, H5Fclose, "open " + path.string())});
                  const int format = read_attribute<int>(id, "checkpoint_format", H5T_NATIVE_INT);
                  if (format != checkpoint_format)
                    throw FileError("The checkpoint " + path.string() + " has the format " +
                                    std::to_string(format) + "; this program reads format " +
                                    std::to_string(checkpoint_format) +
                                    ". Resume with the program that wrote it.");
                });
  for (const auto &name : names_in(file_->id))
    verify(name);
  std::string program;
  common("program", program);
  if (program != version())
    throw FileError(
        "The checkpoint " + path.string() + " was written by ricochet " + program +
        ", and this is " + version() +
        ": the run could not go on as it began. Resume with the program that wrote it.");
}

CheckpointReader::~CheckpointReader() = default;

std::pair<std::size_t, std::size_t> CheckpointReader::shape(const std::string &name)
{
  hsize_t size[2] = {0, 0};
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  const hid_t id = H5Dopen2(file_->id, name.c_str(), H5P_DEFAULT);
                  if (id < 0)
                    throw FileError("The checkpoint " + path_.string() + " lacks '" + name +
                                    "': it belongs to another scene or is damaged. Resume from "
                                    "another one.");
                  const Handle dataset(id, H5Dclose, "find " + name);
                  const Handle space(H5Dget_space(dataset), H5Sclose, "ask for a shape");
                  check(H5Sget_simple_extent_ndims(space) == 2 ? 0 : -1, "understand " + name);
                  check(H5Sget_simple_extent_dims(space, size, nullptr), "ask for a shape");
                });
  return {size[0], size[1]};
}

void CheckpointReader::read(const std::string &name, char *const rows, const std::size_t first,
                            const std::size_t n)
{
  on_every_rank(
      communicator(),
      [&]
      {
        const SilencedReport silenced;
        const Handle dataset(H5Dopen2(file_->id, name.c_str(), H5P_DEFAULT), H5Dclose,
                             "find " + name);
        const Handle space(H5Dget_space(dataset), H5Sclose, "ask for a shape");
        hsize_t size[2];
        check(H5Sget_simple_extent_dims(space, size, nullptr), "ask for a shape");
        if (size[0] == 0 || size[1] == 0)
          return;
        select(space, first, n, size[1]);
        check(H5Dread(dataset, H5T_NATIVE_UINT8, memory_space(n, size[1]), space, together(), rows),
              "read " + name + " of " + path_.string());
      });
}

/// Every rank reads its share of the rows of every dataset, as much at once as it takes.
void CheckpointReader::verify(const std::string &name)
{
  const auto [n, bytes_per_row] = shape(name);
  constexpr std::size_t at_once = 1 << 24; // bytes
  const std::size_t n_ranks = size_of(communicator()), rank = rank_in(communicator()),
                    first = n * rank / n_ranks, last = n * (rank + 1) / n_ranks,
                    step =
                        std::max<std::size_t>(1, at_once / std::max<std::size_t>(1, bytes_per_row));
  // All ranks read equally often.
  const std::size_t n_steps = (n / n_ranks + 1 + step - 1) / step;
  std::vector<char> rows;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < n_steps; ++i)
  {
    const std::size_t from  = std::min(last, first + i * step),
                      count = std::min(last, from + step) - from;
    rows.resize(count * bytes_per_row);
    read(name, rows.data(), from, count);
    sum += checksum_of(rows.data(), bytes_per_row, from, count);
  }
  sum = sum_over_ranks(communicator(), sum);
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  const Handle dataset(H5Dopen2(file_->id, name.c_str(), H5P_DEFAULT), H5Dclose,
                                       "find " + name);
                  if (read_attribute<std::uint64_t>(dataset, checksum_name, H5T_NATIVE_UINT64) !=
                      sum)
                    throw FileError("The checkpoint " + path_.string() + " is damaged: '" + name +
                                    "' does not match its checksum. Resume from another one.");
                });
}

namespace
{
[[noreturn]] void fail_to_fit(const std::filesystem::path &path, const std::string &name)
{
  throw FileError("The checkpoint " + path.string() + " does not fit the scene: '" + name +
                  "' has another size. Resume with the parameters it was written with.");
}
} // namespace

std::size_t CheckpointReader::common_size(const std::string &name)
{
  return shape(name).second;
}

void CheckpointReader::common_bytes(const std::string &name, char *const values,
                                    const std::size_t n)
{
  if (shape(name) != std::pair<std::size_t, std::size_t>{1, n})
    fail_to_fit(path_, name);
  read(name, values, 0, 1);
}

void CheckpointReader::planes_bytes(const std::string &name, char *const values,
                                    const std::size_t bytes_per_plane, const PlaneShare &share)
{
  if (shape(name) !=
      std::pair<std::size_t, std::size_t>{static_cast<std::size_t>(share.n), bytes_per_plane})
    fail_to_fit(path_, name);
  const int first = std::max(0, share.first_local), last = std::min(share.n, share.last_local);
  char *const begin =
      values + static_cast<std::size_t>(first - share.first_local) * bytes_per_plane;
  read(name, begin, static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
}

void CheckpointReader::rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
                               std::vector<double> &values, const std::size_t n_columns)
{
  constexpr std::size_t at_once  = 1 << 16;
  const std::string name_of_keys = name + " keys";
  const auto n                   = shape(name).first;
  if (shape(name).second != n_columns * sizeof(double) ||
      shape(name_of_keys) != std::pair<std::size_t, std::size_t>{n, sizeof(std::int64_t)})
    fail_to_fit(path_, name);
  std::unordered_map<std::int64_t, std::size_t> wanted;
  for (std::size_t i = 0; i < keys.size(); ++i)
    wanted.emplace(keys[i], i);
  std::size_t n_found = 0;
  values.resize(keys.size() * n_columns);
  for (std::size_t first = 0; first < n; first += at_once)
  {
    const std::size_t count = std::min(at_once, n - first);
    std::vector<std::int64_t> some_keys(count);
    std::vector<double> some(count * n_columns);
    read(name_of_keys, reinterpret_cast<char *>(some_keys.data()), first, count);
    read(name, reinterpret_cast<char *>(some.data()), first, count);
    for (std::size_t i = 0; i < count; ++i)
      if (const auto found = wanted.find(some_keys[i]); found != wanted.end())
      {
        std::copy_n(some.data() + i * n_columns, n_columns,
                    values.data() + found->second * n_columns);
        ++n_found;
      }
  }
  on_every_rank(communicator(),
                [&]
                {
                  if (n_found != keys.size())
                    fail_to_fit(path_, name);
                });
}

void CheckpointReader::by_rank_of(const std::string &name, double *const values,
                                  const std::size_t n)
{
  const auto [n_ranks, bytes] = shape(name);
  if (bytes != n * sizeof(double))
    fail_to_fit(path_, name);
  std::vector<double> all(n_ranks * n);
  read(name, reinterpret_cast<char *>(all.data()), 0, n_ranks);
  const auto rank = static_cast<std::size_t>(rank_in(communicator()));
  if (n_ranks == static_cast<std::size_t>(size_of(communicator())))
  {
    std::copy_n(all.data() + rank * n, n, values);
    return;
  }
  std::fill_n(values, n, 0.);
  for (std::size_t i = 0; i < all.size() && rank == 0; ++i)
    values[i % n] += all[i];
}
} // namespace ricochet
