// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/result_directory.h"

#include "result_marker.h"
#include "ricochet/base/exceptions.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/folder_lock.h"

#include <regex>
#include <string>
#include <vector>

namespace ricochet
{
namespace
{
namespace fs = std::filesystem;

/// Every name a run may leave in its folder and in the folders below; a new kind of result adds
/// its name here.
bool is_result(const fs::path &folder, const std::string &name)
{
  static const std::regex top("((history|section|damage)\\.(h5|png)|reference\\.png|report\\.html|"
                              "history\\.csv|summary\\.json|results\\.pvd|used\\.prm)"
                              "(\\.tmp)?");
  static const std::regex vtu(
      "((points|elements)_[0-9]{4,}\\.(pvtu|[0-9]{3,}\\.vtu)|projectile_[0-9]{4,}\\.vtu)(\\.tmp)?");
  static const std::regex section("frame_[0-9]{4,}\\.h5(\\.tmp)?");
  static const std::regex checkpoint("rank_[0-9]{4,}\\.h5(\\.tmp)?");
  return std::regex_match(name, folder.empty()        ? top
                                : folder == "vtu"     ? vtu
                                : folder == "section" ? section
                                                      : checkpoint);
}

/// A link may lead anywhere: only true folders are entered below the one that the user has named.
bool is_true_folder(const fs::path &path)
{
  return fs::is_directory(fs::symlink_status(path));
}

/// Those that a run makes in its own, deepest first.
std::vector<fs::path> folders_in(const fs::path &path)
{
  static const std::regex step("step_[0-9]{9,}(\\.tmp)?");
  std::vector<fs::path> folders;
  if (is_true_folder(path / "checkpoint"))
    for (const fs::directory_entry &entry : fs::directory_iterator(path / "checkpoint"))
      if (is_true_folder(entry.path()) && std::regex_match(entry.path().filename().string(), step))
        folders.push_back("checkpoint" / entry.path().filename());
  for (const char *folder : {"checkpoint", "vtu", "section"})
    if (is_true_folder(path / folder))
      folders.emplace_back(folder);
  return folders;
}

std::vector<fs::path> results_in(const fs::path &path)
{
  std::vector<fs::path> found;
  auto folders = folders_in(path);
  folders.emplace_back("");
  for (const fs::path &folder : folders)
    for (const fs::directory_entry &entry : fs::directory_iterator(path / folder))
      if (fs::is_regular_file(entry.symlink_status()) &&
          is_result(folder, entry.path().filename().string()))
        found.push_back(entry.path());
  return found;
}

void remove_results(const fs::path &path)
{
  const std::vector<fs::path> results = results_in(path);
  if (!results.empty() && !fs::exists(path / result_marker))
    throw FileError("The results folder " + path.string() + " contains " +
                    results.front().filename().string() + ", but not the mark " + result_marker +
                    " of an earlier run; it will not be overwritten. Choose another folder or "
                    "remove the file.");
  for (const fs::path &file : results)
    fs::remove(file);
  for (const fs::path &folder : folders_in(path))
  {
    std::error_code not_empty; // then it holds files of the user and stays
    fs::remove(path / folder, not_empty);
  }
}

void prepare(const fs::path &path, const bool force)
{
  if (path.empty())
    throw FileError("The name of the results folder is empty. Give a name in the parameter file.");
  if (fs::exists(path) && !fs::is_directory(path))
    throw FileError("The results folder " + path.string() +
                    " is a file. Choose another name or remove it.");
  if (fs::exists(path) && !fs::is_empty(path) && !force)
    throw FileError("The results folder " + path.string() +
                    " is not empty. Choose another one, or use --force to replace the results of "
                    "an earlier run in "
                    "it (other files stay).");
  make_directory(path);
  {
    const FolderLock nobody_is_at_work(path);
    if (force)
      remove_results(path);
  }
  // Whoever locks the mark locks this file: it is never replaced.
  if (!fs::exists(path / result_marker))
    write_file(path / result_marker,
               "This folder holds results of a ricochet run; --force may replace them.\n");
}
} // namespace

void prepare_result_directory(const MPI_Comm comm, const fs::path &path, const bool force)
{
  on_first_rank(comm,
                [&]
                {
                  try
                  {
                    prepare(path, force);
                  }
                  catch (const fs::filesystem_error &error)
                  {
                    throw FileError("Cannot prepare the results folder " + path.string() + ": " +
                                    error.code().message() +
                                    ". Choose a folder in which you may read and write.");
                  }
                });
}
} // namespace ricochet
