// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hdf5_file.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/version.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/checkpoint_file.h"
#include "ricochet/output/collective.h"

namespace ricochet
{
CheckpointWriter::CheckpointWriter(const MPI_Comm communicator) :
  StateArchive(communicator), file_(std::make_unique<Hdf5File>())
{
  file_->set_attribute("checkpoint_format", checkpoint_format);
  file_->set_attribute("ranks", size_of(communicator));
  std::string program = version();
  common("program", program);
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::save(const std::filesystem::path &folder)
{
  auto temporary = folder;
  temporary += ".tmp";
  const auto remove = [](const std::filesystem::path &path)
  {
    std::error_code ignored; // what is in the way is noticed when it is written to
    std::filesystem::remove_all(path, ignored);
  };
  try
  {
    on_first_rank(communicator(),
                  [&]
                  {
                    remove(temporary);
                    make_directory(temporary);
                  });
    on_every_rank(communicator(),
                  [&]
                  {
                    const auto rank = static_cast<unsigned int>(rank_in(communicator()));
                    file_->save(temporary / ("rank_" + with_zeros(rank, 4) + ".h5"),
                                Durability::on_disk);
                  });
    on_first_rank(communicator(),
                  [&]
                  {
                    remove(folder);
                    name_folder(temporary, folder);
                  });
  }
  catch (const FileError &)
  {
    if (rank_in(communicator()) == 0)
      remove(temporary);
    throw;
  }
}

void CheckpointWriter::common_bytes(const std::string &name, char *const values,
                                    const std::size_t n)
{
  file_->add(name, values, {n, 0, rank_in(communicator()) == 0 ? 1u : 0u, 1});
}

std::size_t CheckpointWriter::common_size(const std::string &)
{
  return 0; // asked when restoring alone
}

void CheckpointWriter::planes_bytes(const std::string &name, char *const values,
                                    const std::size_t bytes_per_plane, const PlaneShare &share)
{
  const auto first = static_cast<std::size_t>(share.first);
  file_->add(name,
             values + static_cast<std::size_t>(share.first - share.first_local) * bytes_per_plane,
             {bytes_per_plane, first, static_cast<std::size_t>(share.last) - first,
              static_cast<std::size_t>(share.n)});
}

void CheckpointWriter::rows_of(const std::string &name, const std::vector<std::int64_t> &keys,
                               std::vector<double> &values, const std::size_t n_columns)
{
  std::uint64_t n = keys.size(), end = 0, n_in_all = 0;
  MPI_Scan(&n, &end, 1, MPI_UINT64_T, MPI_SUM, communicator());
  MPI_Allreduce(&n, &n_in_all, 1, MPI_UINT64_T, MPI_SUM, communicator());
  file_->add(name + " keys", reinterpret_cast<const char *>(keys.data()),
             {sizeof(std::int64_t), end - n, n, n_in_all});
  file_->add(name, reinterpret_cast<const char *>(values.data()),
             {n_columns * sizeof(double), end - n, n, n_in_all});
}
} // namespace ricochet
