// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/checked_file.h"

#include "ricochet/base/exceptions.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace ricochet
{
namespace
{
std::string remedy(const int reason)
{
  switch (reason)
  {
    case ENOSPC:
    case EDQUOT:
      return "Free some space, choose a folder on another disk, or write fewer frames.";
    case EFBIG:
      return "Raise the limit on the size of files (ulimit -f) or write fewer frames.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a results folder in which you may write.";
    case ENOENT:
    case ENOTDIR:
      return "Check that the folder exists and was not removed during the run.";
    case EMFILE:
    case ENFILE:
      return "Raise the limit on open files (ulimit -n).";
    default:
      return "Check the disk and the folder.";
  }
}

[[noreturn]] void fail(const std::string &what, const std::filesystem::path &path, const int reason)
{
  throw FileError("Cannot " + what + " " + path.string() + ": " + std::strerror(reason) + ". " +
                  remedy(reason));
}

int open_emptied(const std::filesystem::path &path)
{
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    fail("create", path, errno);
  return descriptor;
}

/// Returns 0 or the reason why not everything could be written.
int write_all(const int descriptor, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return n < 0 ? errno : ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}
} // namespace

void write_file(const std::filesystem::path &path, const std::string_view bytes,
                const Durability durability)
{
  // Each result file has one writer, so a fixed temporary name is enough and a later run finds and
  // replaces leftovers.
  std::filesystem::path temporary = path;
  temporary += ".tmp";

  const int descriptor = open_emptied(temporary);
  int reason           = write_all(descriptor, bytes);
  if (reason == 0 && durability == Durability::on_disk && ::fsync(descriptor) != 0)
    reason = errno;
  if (::close(descriptor) != 0 && reason == 0)
    reason = errno;
  if (reason == 0 && ::rename(temporary.c_str(), path.c_str()) != 0)
    reason = errno;
  if (reason != 0)
  {
    ::unlink(temporary.c_str());
    fail("write", path, reason);
  }
}

void name_folder(const std::filesystem::path &temporary, const std::filesystem::path &folder)
{
  if (::rename(temporary.c_str(), folder.c_str()) != 0)
    fail("write", folder, errno);
  // The name is on disk when the folder around it is. Where that cannot be asked for, the system
  // sees to it.
  if (const int descriptor = ::open(folder.parent_path().c_str(), O_RDONLY | O_CLOEXEC);
      descriptor >= 0)
  {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

void make_directory(const std::filesystem::path &path)
{
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    fail("create the folder", path, error.value());
  if (!std::filesystem::is_directory(path, error))
    fail("create the folder", path, ENOTDIR);
}

AppendedFile::AppendedFile(const std::filesystem::path &path) :
  path_(path), descriptor_(open_emptied(path))
{
}

AppendedFile::~AppendedFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void AppendedFile::append(const std::string_view text)
{
  if (const int reason = write_all(descriptor_, text))
  {
    // If even this fails the last line is incomplete, which readers must expect of a broken run
    // anyway.
    const bool restored =
        ::ftruncate(descriptor_, size_) == 0 && ::lseek(descriptor_, size_, SEEK_SET) == size_;
    fail(restored ? "write" : "write completely", path_, reason);
  }
  size_ += static_cast<long long>(text.size());
}

void AppendedFile::close()
{
  if (descriptor_ < 0)
    return;
  const int result = ::close(descriptor_);
  descriptor_      = -1;
  if (result != 0)
    fail("close", path_, errno);
}
} // namespace ricochet
