// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scripts.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace ricochet
{
namespace
{
/// All that comes until the other end is closed; returns false if that takes longer than the limit.
bool read_all(const int descriptor, const std::chrono::seconds limit, std::string &text)
{
  const auto end = std::chrono::steady_clock::now() + limit;
  std::array<char, 4096> buffer;
  for (;;)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        end - std::chrono::steady_clock::now());
    pollfd watched{descriptor, POLLIN, 0};
    const int ready = poll(&watched, 1, static_cast<int>(std::max<long>(0, left.count())));
    if (ready == 0)
      return false;
    const ssize_t n = ready < 0 ? -1 : read(descriptor, buffer.data(), buffer.size());
    if (n > 0)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    else if (n == 0 || errno != EINTR)
      return true;
  }
}

/// Its exit status; ProgramResult::not_ended if it ended otherwise.
int wait_for(const pid_t child)
{
  int status = 0;
  pid_t waited;
  do
    waited = waitpid(child, &status, 0);
  while (waited < 0 && errno == EINTR);
  return waited == child && WIFEXITED(status) ? WEXITSTATUS(status) : ProgramResult::not_ended;
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

int start_program(const std::vector<std::string> &words, const int pipe_end, const short apart,
                  pid_t &process)
{
  std::vector<char *> arguments, variables = environment_without_mpi();
  for (const auto &word : words)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDERR_FILENO);
  posix_spawnattr_t attributes; // a group of its own is number 0 by default
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, apart);
  const int reason = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(),
                                  variables.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

ProgramResult run_program(const std::string &program, const std::vector<std::string> &arguments,
                          const std::chrono::seconds limit)
{
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return {ProgramResult::not_run, std::strerror(errno)};
  // In a session of its own: mpirun, when it is asked to end, kills the groups of its processes,
  // and what has been begun is drawn to the end all the same.
  pid_t child      = 0;
  const int reason = start_program(words, ends[1], POSIX_SPAWN_SETSID, child);
  close(ends[1]);
  ProgramResult result{ProgramResult::not_run, ""};
  if (reason != 0)
    result.text = program + ": " + std::strerror(reason);
  else
  {
    const bool ended = read_all(ends[0], limit, result.text);
    if (!ended)
      kill(child, SIGKILL);
    result.status = wait_for(child);
    if (!ended)
      result.text = "it had not ended after " + std::to_string(limit.count()) + " s";
  }
  close(ends[0]);
  return result;
}
} // namespace ricochet
