// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result_folder.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/checked_file.h"
#include "ricochet/output/collective.h"
#include "ricochet/output/result_directory.h"
#include "ricochet/scene/scene_reader.h"

#include <fstream>
#include <sstream>

namespace ricochet
{
std::string used_parameters(const ParameterFile &file)
{
  std::ostringstream used;
  write_used_parameters(file, used);
  return used.str();
}

void write_used_parameters_to(const MPI_Comm communicator, const std::filesystem::path &directory,
                              const ParameterFile &file)
{
  on_first_rank(communicator, [&] { write_file(directory / "used.prm", used_parameters(file)); });
}

std::string parameters_of_unfinished_run(const MPI_Comm communicator,
                                         const std::filesystem::path &directory)
{
  std::string text;
  on_first_rank(communicator,
                [&]
                {
                  std::ifstream file(directory / "used.prm");
                  if (!file || std::filesystem::exists(directory / "summary.json"))
                    throw FileError("There is nothing to go on with in " + directory.string() +
                                    ": no checkpoint, and no run that was stopped before its first "
                                    "one. Give the results folder of a run, or start it anew.");
                  std::ostringstream all;
                  all << file.rdbuf();
                  text = all.str();
                });
  return broadcast(communicator, text, 0);
}

void prepare_result_folder(const MPI_Comm communicator, const std::filesystem::path &directory,
                           const ParameterFile &file, const bool force)
{
  prepare_result_directory(communicator, directory, force);
  write_used_parameters_to(communicator, directory, file);
}
} // namespace ricochet
