// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder of a run before its first result.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// All parameters that the file gives or implies, as text.
std::string used_parameters(const ParameterFile &file);

/// Writes them into the folder as used.prm. Collective; throws FileError on all ranks.
void write_used_parameters_to(MPI_Comm communicator, const std::filesystem::path &directory,
                              const ParameterFile &file);

/// The same of a run in that folder that has come to no end. Collective; throws FileError on all
/// ranks if there is none.
std::string parameters_of_unfinished_run(MPI_Comm communicator,
                                         const std::filesystem::path &directory);

/// Prepares the folder, see prepare_result_directory(), and writes used.prm into it. Collective;
/// throws FileError on all ranks.
void prepare_result_folder(MPI_Comm communicator, const std::filesystem::path &directory,
                           const ParameterFile &file, bool force);
} // namespace ricochet
