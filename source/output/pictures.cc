// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/output/pictures.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/output/collective.h"
#include "scripts.h"

#include <iostream>
#include <string>
#include <vector>

namespace ricochet
{
namespace
{
const char *const report = "report";
const int missing_module = 3; // exit status of the scripts if matplotlib or h5py are not installed

std::string last_line(std::string text)
{
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text.substr(text.rfind('\n') + 1); // npos + 1 is 0
}

/// Debian's own python comes first, because another one in the path does not see Debian's
/// matplotlib.
ProgramResult run_python(const std::vector<std::string> &arguments)
{
  ProgramResult debian = run_program("/usr/bin/python3", arguments);
  if (debian.status != ProgramResult::not_run && debian.status != missing_module)
    return debian;
  ProgramResult other = run_program("python3", arguments);
  return other.status != ProgramResult::not_run ? other : debian;
}

/// `what` is missing if it fails: "pictures".
bool draw(const char *name, const std::vector<std::filesystem::path> &paths, const bool quiet,
          const std::string &what)
{
  const std::filesystem::path script = script_folder(this_program()) / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(script, error))
  {
    std::cerr
        << "No " << what << ": " << script.string()
        << " does not exist. Set the environment variable RICOCHET_SCRIPT_DIR to its folder.\n";
    return false;
  }

  // Absolute, so that a folder whose name begins with a dash is not taken for an option.
  std::vector<std::string> arguments = {script.string()};
  for (const auto &path : paths)
    arguments.push_back(std::filesystem::absolute(path).string());
  const ProgramResult result = run_python(arguments);
  if (result.status == 0)
  {
    if (!quiet)
      std::cout << last_line(result.text) << std::endl;
    return true;
  }
  if (what == report && result.status == ProgramResult::not_run)
    std::cerr << "No report: it needs python3 (apt install python3), then " << name << " "
              << paths[0].string() << "\n";
  else if (result.status == missing_module || result.status == ProgramResult::not_run)
    std::cerr << "No " << what
              << ": they need python3 with matplotlib and h5py (apt install "
                 "python3-matplotlib python3-h5py), then "
              << name << " " << paths[0].string() << "\n";
  else
    std::cerr << "No " << what << ": " << script.string() << " failed: " << last_line(result.text)
              << "\n";
  return false;
}

/// Collective; the same answer on all ranks.
bool draw_on_first_rank(const MPI_Comm comm, const char *script,
                        const std::vector<std::filesystem::path> &arguments, const bool quiet,
                        const std::string &what = "pictures")
{
  bool drawn = false;
  on_first_rank(comm, [&] { drawn = draw(script, arguments, quiet, what); });
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

bool write_report(const MPI_Comm comm, const std::filesystem::path &directory, const bool quiet)
{
  return draw_on_first_rank(comm, "make_report.py", {directory}, quiet, report);
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
