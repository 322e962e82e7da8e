// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoints.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/output/checkpoint_file.h"
#include "ricochet/scene/scene.h"
#include "warning.h"

#include <algorithm>

namespace ricochet
{
namespace
{
namespace fs = std::filesystem;

fs::path folder_in(const fs::path &directory)
{
  return directory / "checkpoint";
}

/// As rank 0 sees them, newest first, on all ranks. Names begin with the step.
std::vector<std::string> checkpoints_in(const MPI_Comm communicator, const fs::path &directory)
{
  std::string names;
  if (rank_in(communicator) == 0)
  {
    std::vector<std::string> found;
    std::error_code none;
    for (const auto &entry : fs::directory_iterator(folder_in(directory), none))
      if (entry.is_directory() && entry.path().extension().empty())
        found.push_back(entry.path().filename().string());
    std::sort(found.rbegin(), found.rend());
    for (const auto &name : found)
      names += name + '\n';
  }
  names = broadcast(communicator, names, 0);
  std::vector<std::string> list;
  for (std::size_t at = 0, end; (end = names.find('\n', at)) != std::string::npos; at = end + 1)
    list.push_back(names.substr(at, end - at));
  return list;
}
} // namespace

Checkpoints::Checkpoints(const MPI_Comm communicator, const OutputParameters &output,
                         std::string parameters) :
  communicator_(communicator),
  directory_(output.directory), in_time_(output.checkpoint_interval),
  wall_interval_(output.checkpoint_wall_interval), parameters_(std::move(parameters))
{
  in_time_.done(0.); // the beginning is in the parameters
  // Halves that a process which was killed has left: the folder is locked, so nobody writes them.
  std::error_code ignored;
  if (rank_in(communicator_) == 0)
    for (const auto &entry : fs::directory_iterator(folder_in(directory_), ignored))
      if (entry.path().extension() == ".tmp")
        fs::remove_all(entry.path(), ignored);
}

bool Checkpoints::is_due(const double time) const
{
  if (in_time_.is_due(time))
    return true;
  if (wall_interval_ == 0.)
    return false;
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count();
  return broadcast(communicator_, elapsed >= wall_interval_, 0);
}

void Checkpoints::write(const long step, const double time, const ExchangeState &exchange_state)
{
  in_time_.done(time);
  const std::string name = "step_" + with_zeros(static_cast<unsigned int>(step), 9);
  try
  {
    CheckpointWriter archive(communicator_);
    archive.common("parameters", parameters_);
    exchange_state(archive);
    archive.save(folder_in(directory_) / name);
  }
  catch (const FileError &error)
  {
    warn(communicator_, std::string("no checkpoint: ") + error.what() +
                            " The run goes on; earlier checkpoints are kept.");
  }
  last_                      = std::chrono::steady_clock::now();
  constexpr std::size_t kept = 2; // the one before, should the last one be damaged
  const auto all             = checkpoints_in(communicator_, directory_);
  std::error_code ignored;
  for (std::size_t i = kept; i < all.size() && rank_in(communicator_) == 0; ++i)
    fs::remove_all(folder_in(directory_) / all[i], ignored);
}

bool has_checkpoints(const MPI_Comm communicator, const fs::path &directory)
{
  return !checkpoints_in(communicator, directory).empty();
}

ResumedState newest_checkpoint(const MPI_Comm communicator, const fs::path &directory)
{
  for (const auto &name : checkpoints_in(communicator, directory))
    try
    {
      ResumedState state;
      state.path    = folder_in(directory) / name;
      state.archive = std::make_unique<CheckpointReader>(communicator, state.path);
      state.archive->common("parameters", state.parameters);
      return state;
    }
    catch (const FileError &error)
    {
      warn(communicator, error.what());
    }
  throw FileError("There is no whole checkpoint in " + folder_in(directory).string() +
                  " that this version of the program can read. Start the run anew, with --force to "
                  "replace its results.");
}
} // namespace ricochet
