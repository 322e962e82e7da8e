// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/folder_lock.h"

#include "result_marker.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/output/collective.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace ricochet
{
FolderLock::FolderLock(const MPI_Comm communicator, const std::filesystem::path &folder)
{
  on_first_rank(communicator, [&] { take(folder); });
}

FolderLock::FolderLock(const std::filesystem::path &folder)
{
  take(folder);
}

FolderLock::~FolderLock()
{
  if (descriptor_ >= 0)
    close(descriptor_);
}

void FolderLock::take(const std::filesystem::path &folder)
{
  descriptor_ = open((folder / result_marker).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
    return;
  close(descriptor_);
  descriptor_ = -1;
  throw FileError("Another ricochet process is at work in the results folder " + folder.string() +
                  ". Wait until it has ended, or end it, or choose another folder.");
}
} // namespace ricochet
