// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder that receives the results of one run: never mixes two runs and never removes a file of
// the user.
#pragma once

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// Creates the folder, with its parents, and makes sure that it can be written. A folder that has
/// content is refused unless `force`; then the results of an earlier run in it are removed, by
/// their known names, and everything else stays. A hidden file ".ricochet" marks a folder as ours:
/// without it `force` removes nothing, and refuses the folder if it has files with names of
/// results. Collective; throws FileError on all ranks.
void prepare_result_directory(MPI_Comm comm, const std::filesystem::path &path, bool force);
} // namespace ricochet
