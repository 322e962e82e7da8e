// SPDX-License-Identifier: LGPL-2.1-or-later
// A case of a study on disk: what an earlier run has left, and that one process runs it at a time.
#pragma once

#include "ricochet/scene/parameter_file.h"

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
