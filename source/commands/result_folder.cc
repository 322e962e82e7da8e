// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result_folder.h"

#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/scene/scene_reader.h"

#include <sstream>

namespace ricochet
{
void prepare_result_folder(const MPI_Comm communicator, const std::filesystem::path &directory,
                           const ParameterFile &file, const bool force)
{
  prepare_result_directory(communicator, directory, force);
  on_first_rank(communicator,
                [&]
                {
                  std::ostringstream used;
                  write_used_parameters(file, used);
                  write_file(directory / "used.prm", used.str());
                });
}
} // namespace ricochet
