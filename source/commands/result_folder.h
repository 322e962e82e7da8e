// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder of a run before its first result.
#pragma once

#include "ricochet/scene/parameter_file.h"

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// Prepares the folder, see prepare_result_directory(), and writes used.prm into it: all parameters
/// that the file gives or implies. Collective; throws FileError on all ranks.
void prepare_result_folder(MPI_Comm communicator, const std::filesystem::path &directory,
                           const ParameterFile &file, bool force);
} // namespace ricochet
