// SPDX-License-Identifier: LGPL-2.1-or-later
// One run at a time in a results folder.
#pragma once

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// While it lives, no other process has the folder. It ends with the process, however that ends.
class FolderLock
{
public:
  /// Of a folder that prepare_result_directory() has marked; of any other it is without effect, as
  /// on file systems without locks. Throws FileError on all ranks if another process has it, of
  /// this machine or of one that shares the disk. Collective.
  FolderLock(MPI_Comm communicator, const std::filesystem::path &folder);
  /// The same for this process alone.
  explicit FolderLock(const std::filesystem::path &folder);
  ~FolderLock();
  FolderLock(const FolderLock &)            = delete;
  FolderLock &operator=(const FolderLock &) = delete;

private:
  void take(const std::filesystem::path &folder);

  int descriptor_ = -1;
};
} // namespace ricochet
