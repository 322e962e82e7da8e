// SPDX-License-Identifier: LGPL-2.1-or-later
#include "several_processes.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

namespace ricochet
{
std::optional<int> launched_rank()
{
  // Open MPI's mpirun; srun and others by way of PMIx or PMI.
  for (const char *name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (const char *const rank = std::getenv(name))
      return std::atoi(rank);
  return {};
}

int start_processes(const int n, const int argc, char **argv)
{
  if (n < 2 || std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
    return 0;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  // More processes than cores are slow but not wrong, and binding them would pin them to one core.
  std::vector<std::string> words{"mpirun",
                                 "--oversubscribe",
                                 "--bind-to",
                                 "none",
                                 "-np",
                                 std::to_string(n),
                                 error ? argv[0] : program.string()};
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char *> command;
  command.reserve(words.size() + 1);
  for (auto &word : words)
    command.push_back(word.data());
  command.push_back(nullptr);
  execvp(command[0], command.data());
  std::cerr << "ricochet: mpirun could not be started: " << std::strerror(errno)
            << ". Install openmpi-bin, or leave out --processes." << std::endl;
  return 3;
}
} // namespace ricochet
