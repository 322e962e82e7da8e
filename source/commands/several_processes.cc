// SPDX-License-Identifier: LGPL-2.1-or-later
#include "several_processes.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

namespace ricochet
{
namespace
{
/// The number behind --processes; 1 if there is none. What is not a number is left to the parser of
/// the command line, which explains it.
long processes_asked(const int argc, char **argv)
{
  const std::string option = "--processes";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const char *number         = nullptr;
    if (argument == option && i + 1 < argc)
      number = argv[i + 1];
    else if (argument.rfind(option + "=", 0) == 0)
      number = argv[i] + option.size() + 1;
    if (number != nullptr)
      return std::strtol(number, nullptr, 10);
  }
  return 1;
}
} // namespace

int start_processes(const int argc, char **argv)
{
  const long n = processes_asked(argc, argv);
  if (n < 2 || n > most_processes || std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
    return 0;
  const std::string count = std::to_string(n);
  // More processes than cores are slow but not wrong, and binding them would pin them to one core.
  std::vector<char *> command;
  for (const char *word :
       {"mpirun", "--oversubscribe", "--bind-to", "none", "-np", count.c_str(), "/proc/self/exe"})
    command.push_back(const_cast<char *>(word));
  std::vector<char> program(4096, '\0');
  if (readlink("/proc/self/exe", program.data(), program.size() - 1) > 0)
    command.back() = program.data();
  for (int i = 1; i < argc; ++i)
    command.push_back(argv[i]);
  command.push_back(nullptr);
  execvp(command[0], command.data());
  std::fprintf(stderr,
               "ricochet: mpirun could not be started: %s. Install openmpi-bin, or leave out "
               "--processes.\n",
               std::strerror(errno));
  return 3;
}
} // namespace ricochet
