// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/pictures.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/collective.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#ifndef RICOCHET_SCRIPT_DIR
#error "RICOCHET_SCRIPT_DIR must name the folder of the scripts plot_*.py"
#endif

extern char **environ;

namespace ricochet
{
namespace
{
const int missing_module = 3; // exit status of the scripts if matplotlib or h5py are not installed

struct Outcome
{
  int status;       // exit status, or -1 if the program could not be run
  std::string text; // what it printed
};

/// The environment without the marks of an MPI process, which would make h5py start MPI in the
/// script.
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

/// Runs a program with arguments, no shell in between, and waits for it. posix_spawn and not fork,
/// because a fork of a process with MPI's registered memory is not safe.
Outcome run(const std::string &program, const std::vector<std::string> &arguments)
{
  std::vector<char *> argv = {const_cast<char *>(program.c_str())};
  for (const std::string &argument : arguments)
    argv.push_back(const_cast<char *>(argument.c_str()));
  argv.push_back(nullptr);
  std::vector<char *> variables = environment_without_mpi();

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return {-1, std::strerror(errno)};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  pid_t child = 0;
  const int result =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), variables.data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (result != 0)
  {
    close(ends[0]);
    return {-1, program + ": " + std::strerror(result)};
  }

  Outcome outcome{-1, ""};
  std::array<char, 4096> buffer;
  ssize_t n;
  while ((n = read(ends[0], buffer.data(), buffer.size())) > 0 || (n < 0 && errno == EINTR))
    if (n > 0)
      outcome.text.append(buffer.data(), static_cast<std::size_t>(n));
  close(ends[0]);

  int status = 0;
  pid_t waited;
  do
    waited = waitpid(child, &status, 0);
  while (waited < 0 && errno == EINTR);
  if (waited == child && WIFEXITED(status))
    outcome.status = WEXITSTATUS(status);
  return outcome;
}

std::string last_line(std::string text)
{
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text.substr(text.rfind('\n') + 1); // npos + 1 is 0
}

bool draw(const char *name, const std::vector<std::filesystem::path> &paths, const bool quiet)
{
  const char *folder = std::getenv("RICOCHET_SCRIPT_DIR");
  const std::filesystem::path script =
      std::filesystem::path(folder ? folder : RICOCHET_SCRIPT_DIR) / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(script, error))
  {
    std::cerr
        << "No pictures: " << script.string()
        << " does not exist. Set the environment variable RICOCHET_SCRIPT_DIR to its folder.\n";
    return false;
  }

  // Absolute, so that a folder whose name begins with a dash is not taken for an option. Debian's
  // own python comes first, because another one in the path does not see Debian's matplotlib.
  std::vector<std::string> arguments = {script.string()};
  for (const auto &path : paths)
    arguments.push_back(std::filesystem::absolute(path).string());
  Outcome outcome = run("/usr/bin/python3", arguments);
  if (outcome.status == -1 || outcome.status == missing_module)
  {
    const Outcome other = run("python3", arguments);
    if (other.status != -1)
      outcome = other;
  }

  if (outcome.status == 0)
  {
    if (!quiet)
      std::cout << last_line(outcome.text) << std::endl;
    return true;
  }
  if (outcome.status == missing_module || outcome.status == -1)
    std::cerr << "No pictures: they need python3 with matplotlib and h5py (apt install "
                 "python3-matplotlib "
                 "python3-h5py), then "
              << name << " " << paths[0].string() << "\n";
  else
    std::cerr << "No pictures: " << script.string() << " failed: " << last_line(outcome.text)
              << "\n";
  return false;
}

/// Collective; the same answer on all ranks.
bool draw_on_first_rank(const MPI_Comm comm, const char *script,
                        const std::vector<std::filesystem::path> &arguments, const bool quiet)
{
  bool drawn = false;
  on_first_rank(comm, [&] { drawn = draw(script, arguments, quiet); });
  return broadcast(comm, drawn, /*root=*/0);
}
} // namespace

bool draw_pictures(const MPI_Comm comm, const std::filesystem::path &directory, const bool quiet)
{
  return draw_on_first_rank(comm, "plot_run.py", {directory}, quiet);
}

bool draw_study_picture(const MPI_Comm comm, const std::filesystem::path &directory,
                        const bool quiet)
{
  return draw_on_first_rank(comm, "plot_study.py", {directory}, quiet);
}

bool draw_accuracy_chart(const MPI_Comm comm, const std::filesystem::path &directory,
                         const bool quiet)
{
  return draw_on_first_rank(comm, "plot_accuracy.py", {directory}, quiet);
}

bool draw_search_plot(const MPI_Comm comm, const std::filesystem::path &rows,
                      const std::filesystem::path &picture, const bool quiet)
{
  return draw_on_first_rank(comm, "plot_search.py", {rows, picture}, quiet);
}

bool draw_stability_map(const MPI_Comm comm, const std::filesystem::path &table,
                        const std::filesystem::path &picture, const bool quiet)
{
  return draw_on_first_rank(comm, "plot_stability.py", {table, picture}, quiet);
}
} // namespace ricochet
