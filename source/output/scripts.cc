// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scripts.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace ricochet
{
namespace
{
/// Starts the program with its output into the pipe; 0, or the reason why not. posix_spawn and not
/// fork, because a fork of a process with MPI's registered memory is not safe.
int start(const std::string &program, std::vector<char *> arguments, const int pipe_end,
          pid_t &child)
{
  std::vector<char *> variables = environment_without_mpi();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDERR_FILENO);
  const int reason =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

std::string read_all(const int descriptor)
{
  std::string text;
  std::array<char, 4096> buffer;
  ssize_t n;
  while ((n = read(descriptor, buffer.data(), buffer.size())) > 0 || (n < 0 && errno == EINTR))
    if (n > 0)
      text.append(buffer.data(), static_cast<std::size_t>(n));
  return text;
}

/// Its exit status; -1 if it ended otherwise.
int wait_for(const pid_t child)
{
  int status = 0;
  pid_t waited;
  do
    waited = waitpid(child, &status, 0);
  while (waited < 0 && errno == EINTR);
  return waited == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
} // namespace

std::vector<char *> environment_without_mpi()
{
  std::vector<char *> variables;
  for (char **variable = environ; *variable; ++variable)
  {
    bool keep = true;
    for (const char *prefix : {"OMPI_", "PMIX_", "PMI_", "MPI_LOCALNRANKS", "H5PY_ALWAYS_USE_MPI"})
      keep = keep && std::strncmp(*variable, prefix, std::strlen(prefix)) != 0;
    if (keep)
      variables.push_back(*variable);
  }
  variables.push_back(nullptr);
  return variables;
}

std::filesystem::path script_folder(const std::filesystem::path &program)
{
  if (const char *folder = std::getenv("RICOCHET_SCRIPT_DIR"))
    return folder;
  const auto place           = std::filesystem::path("share") / "ricochet" / "scripts";
  const auto folder          = program.parent_path();
  const auto beside          = folder.parent_path() / place;
  const auto in_build_folder = folder / place;
  std::error_code error;
  return !std::filesystem::is_directory(beside, error) &&
                 std::filesystem::is_directory(in_build_folder, error)
             ? in_build_folder
             : beside;
}

std::filesystem::path this_program()
{
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

ProgramResult run_program(const std::string &program, const std::vector<std::string> &arguments)
{
  std::vector<char *> argv = {const_cast<char *>(program.c_str())};
  for (const std::string &argument : arguments)
    argv.push_back(const_cast<char *>(argument.c_str()));
  argv.push_back(nullptr);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return {-1, std::strerror(errno)};
  pid_t child      = 0;
  const int reason = start(program, argv, ends[1], child);
  close(ends[1]);
  ProgramResult result{-1, ""};
  if (reason != 0)
    result.text = program + ": " + std::strerror(reason);
  else
  {
    result.text   = read_all(ends[0]);
    result.status = wait_for(child);
  }
  close(ends[0]);
  return result;
}
} // namespace ricochet
