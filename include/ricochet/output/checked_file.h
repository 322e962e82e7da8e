// SPDX-License-Identifier: LGPL-2.1-or-later
// The only two ways in which results reach the disk: a whole file that appears complete or not at
// all, and a text file that grows by whole pieces. Every system call is checked; FileError names
// file, reason and remedy.
#pragma once

#include <filesystem>
#include <string_view>

namespace ricochet
{
/// Whether a file must have reached the disk before it gets its name, so that it is whole even if
/// the machine goes down.
enum class Durability
{
  as_others, // when the system sees fit
  on_disk
};

/// Writes a file under a temporary name (path + ".tmp") and renames it, so that a reader, a broken
/// run or a full disk never leaves half a file and an older file of that name survives a failure.
/// Throws FileError.
void write_file(const std::filesystem::path &path, std::string_view bytes,
                Durability durability = Durability::as_others);

/// Gives a folder of files that are on disk its name, which nothing else may have. Throws
/// FileError.
void name_folder(const std::filesystem::path &temporary, const std::filesystem::path &folder);

/// Creates a folder if it does not exist yet. Throws FileError.
void make_directory(const std::filesystem::path &path);

/// A file that is emptied when opened and then only grows. Not copyable.
class AppendedFile
{
public:
  /// Throws FileError if the file cannot be created.
  explicit AppendedFile(const std::filesystem::path &path);
  ~AppendedFile();
  AppendedFile(const AppendedFile &)            = delete;
  AppendedFile &operator=(const AppendedFile &) = delete;

  /// Hands the text to the operating system. If only a part fits, that part is removed again before
  /// FileError is thrown: the file keeps what earlier calls wrote.
  void append(std::string_view text);

  /// Closes the file; a second call does nothing. Throws FileError if the system reports a late
  /// write error.
  void close();

private:
  std::filesystem::path path_;
  int descriptor_;
  long long size_ = 0; // written so far [bytes]
};
} // namespace ricochet
