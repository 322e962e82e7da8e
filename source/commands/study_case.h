// SPDX-License-Identifier: LGPL-2.1-or-later
// A case of a study on disk: what an earlier run has left, and that one process runs it at a time.
#pragma once

#include "ricochet/scene/study_file.h"

#include <mpi.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace ricochet
{
/// What an earlier run has left of a case: its summary if that may stand, or why it may not.
struct Earlier
{
  nlohmann::ordered_json summary; // null: run it
  std::string why_not = "";       // "" if there is nothing at all; of the first rank
};

/// A summary may stand if it is untouched, of this version and of these parameters. The same on all
/// ranks, but for what stands in the summary, which the first one has. Collective.
Earlier earlier_run(MPI_Comm communicator, const ParameterFile &file,
                    const std::filesystem::path &directory);

/// How a case has ended, for the table.
struct CaseEnd
{
  std::string status;             // "ok", "finished before", "failed: why", "interrupted", ...
  nlohmann::ordered_json summary; // null: there is none
};
bool has_failed(const std::string &status);

/// The status that a process of its own leaves behind for the one that has started it, or "".
void leave_status(const std::filesystem::path &study_directory, const std::string &name,
                  const std::string &status);
std::string left_status(const std::filesystem::path &study_directory, const std::string &name);
void forget_status(const std::filesystem::path &study_directory, const std::string &name);

/// What a run has left, of whatever state; null if there is nothing. Of this rank.
nlohmann::ordered_json summary_in(const std::filesystem::path &directory);

/// The lock of a case.
std::filesystem::path lock_of(const std::filesystem::path &study_directory,
                              const std::string &name);

/// Keeps other processes, also of other machines with the same files, from running a case as long
/// as it lives; the system takes it away from a process that dies.
class CaseLock
{
public:
  /// `path` of a file that stays. Collective.
  CaseLock(MPI_Comm communicator, const std::filesystem::path &path);
  ~CaseLock();
  CaseLock(const CaseLock &)            = delete;
  CaseLock &operator=(const CaseLock &) = delete;

  /// False: another process runs the case.
  bool is_held() const { return is_held_; }

private:
  int descriptor_ = -1; // of the first rank
  bool is_held_   = false;
};
} // namespace ricochet
