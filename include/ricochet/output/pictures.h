// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of a finished run or study, drawn by the scripts plot_*.py with Debian's python3,
// matplotlib and h5py. A run is complete without them: whatever goes wrong here costs one line of
// text, never the run.
#pragma once

#include <filesystem>
#include <mpi.h>

namespace ricochet
{
/// Draws DIRECTORY/section.png and DIRECTORY/history.png from the other results and returns whether
/// that worked, the same on all ranks. Rank 0 runs the script in the folder named by the
/// environment variable RICOCHET_SCRIPT_DIR, or else in share/ricochet/scripts beside the program's
/// folder, and says in one line what it drew (unless quiet) or why it could not. Collective.
bool draw_pictures(MPI_Comm comm, const std::filesystem::path &directory, bool quiet);

/// The same with plot_study.py: draws DIRECTORY/comparison.png from study.csv and the results in
/// the folders of the cases. Collective.
bool draw_study_picture(MPI_Comm comm, const std::filesystem::path &directory, bool quiet);

/// The same with plot_accuracy.py: draws DIRECTORY/accuracy.png, the error of the path against the
/// cost, from comparison.csv and comparison_paths.csv. Collective.
bool draw_accuracy_chart(MPI_Comm comm, const std::filesystem::path &directory, bool quiet);

/// Writes DIRECTORY/report.html of a run or study with make_report.py, which needs python3 alone
/// and says in its line if what draws interactive charts is not installed. Collective.
bool write_report(MPI_Comm comm, const std::filesystem::path &directory, bool quiet);

/// The same with plot_search.py: draws the PNG `picture` from the rows of `ricochet bench search
/// --json`, one JSON object per line. Collective.
bool draw_search_plot(MPI_Comm comm, const std::filesystem::path &rows,
                      const std::filesystem::path &picture, bool quiet);

/// The same with plot_stability.py: draws the PNG `picture` from the study.csv of a study of
/// stability experiments. Collective.
bool draw_stability_map(MPI_Comm comm, const std::filesystem::path &table,
                        const std::filesystem::path &picture, bool quiet);
} // namespace ricochet
