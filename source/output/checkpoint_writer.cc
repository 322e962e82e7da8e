// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoint_rows.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/checkpoint_file.h"
#include "ricochet/output/collective.h"

namespace ricochet
{
namespace
{
template <class Value>
void write_attribute(const hid_t owner, const char *const name, const hid_t type, const Value value)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Handle attribute(H5Acreate2(owner, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string("create the attribute ") + name);
  check(H5Awrite(attribute, type, &value), std::string("write the attribute ") + name);
}

std::filesystem::path temporary(const std::filesystem::path &path)
{
  auto name = path;
  return name += ".tmp";
}
} // namespace

struct CheckpointWriter::File
{
  hid_t id = H5I_INVALID_HID;

  void close()
  {
    if (id >= 0)
      check(H5Fclose(std::exchange(id, H5I_INVALID_HID)), "close a checkpoint");
  }
};

CheckpointWriter::CheckpointWriter(const MPI_Comm communicator, const std::filesystem::path &path) :
  StateArchive(communicator), path_(path), file_(std::make_unique<File>())
{
  on_first_rank(communicator, [&] { make_directory(path.parent_path()); });
  on_every_rank(
      communicator,
      [&]
      {
        const SilencedReport silenced;
        const Handle access = file_access(communicator);
        file_->id = H5Fcreate(temporary(path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
        check(file_->id < 0 ? -1 : 0, "create " + path.string());
        write_attribute(file_->id, "checkpoint_format", H5T_NATIVE_INT, checkpoint_format);
      });
  std::string program = version();
  common("program", program);
}

CheckpointWriter::~CheckpointWriter()
{
  if (!file_)
    return;
  const SilencedReport silenced;
  if (file_->id >= 0)
    H5Fclose(file_->id); // whatever it says: the file is not wanted
  std::error_code ignored;
  if (rank_in(communicator()) == 0)
    std::filesystem::remove(temporary(path_), ignored);
}

void CheckpointWriter::commit()
{
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  check(H5Fflush(file_->id, H5F_SCOPE_GLOBAL), "complete " + path_.string());
                  file_->close();
                });
  on_first_rank(communicator(), [&] { give_name(temporary(path_), path_); });
  file_.reset();
}

void CheckpointWriter::write(const std::string &name, const char *const rows,
                             const std::size_t bytes_per_row, const std::size_t first,
                             const std::size_t n, const std::size_t n_in_all)
{
  const auto sum = sum_over_ranks(communicator(), checksum_of(rows, bytes_per_row, first, n));
  on_every_rank(communicator(),
                [&]
                {
                  const SilencedReport silenced;
                  const hsize_t size[2] = {n_in_all, bytes_per_row};
                  const Handle space(H5Screate_simple(2, size, nullptr), H5Sclose,
                                     "create the shape of " + name);
                  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "create a link list");
                  check(H5Pset_create_intermediate_group(links, 1), "ask for groups");
                  const Handle dataset(H5Dcreate2(file_->id, name.c_str(), H5T_NATIVE_UINT8, space,
                                                  links, H5P_DEFAULT, H5P_DEFAULT),
                                       H5Dclose, "create the dataset " + name);
                  write_attribute(dataset, checksum_name, H5T_NATIVE_UINT64, sum);
                  if (n_in_all == 0 || bytes_per_row == 0)
                    return;
                  select(space, first, n, bytes_per_row);
                  check(H5Dwrite(dataset, H5T_NATIVE_UINT8, memory_space(n, bytes_per_row), space,
                                 together(), rows),
                        "write the dataset " + name);
                });
}

void CheckpointWriter::common_bytes(const std::string &name, char *const values,
                                    const std::size_t n)
{
  write(name, values, n, 0, rank_in(communicator()) == 0 ? 1 : 0, 1);
}

std::size_t CheckpointWriter::common_size(const std::string &)
{
  return 0; // asked when restoring alone
}

void CheckpointWriter::planes_bytes(const std::string &name, char *const values,
                                    const std::size_t bytes_per_plane, const PlaneShare &share)
{
  write(name, values + static_cast<std::size_t>(share.first - share.first_local) * bytes_per_plane,
        bytes_per_plane, static_cast<std::size_t>(share.first),
        static_cast<std::size_t>(share.last - share.first), static_cast<std::size_t>(share.n));
}

void CheckpointWriter::rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
                               std::vector<double> &values, const std::size_t n_columns)
{
  std::uint64_t n = keys.size(), end = 0, n_in_all = 0;
  MPI_Scan(&n, &end, 1, MPI_UINT64_T, MPI_SUM, communicator());
  MPI_Allreduce(&n, &n_in_all, 1, MPI_UINT64_T, MPI_SUM, communicator());
  write(name + " keys", reinterpret_cast<const char *>(keys.data()), sizeof(std::int64_t), end - n,
        n, n_in_all);
  write(name, reinterpret_cast<const char *>(values.data()), n_columns * sizeof(double), end - n, n,
        n_in_all);
}

void CheckpointWriter::by_rank_of(const std::string &name, double *const values,
                                  const std::size_t n)
{
  write(name, reinterpret_cast<const char *>(values), n * sizeof(double),
        static_cast<std::size_t>(rank_in(communicator())), 1,
        static_cast<std::size_t>(size_of(communicator())));
}
} // namespace ricochet
