// SPDX-License-Identifier: LGPL-2.1-or-later
// Many runs of a base scene over the axes of a study file: one table, one CSV.
#pragma once

#include <mpi.h>

#include <string>

namespace ricochet
{
struct StudyOptions
{
  bool resume      = false; // go on in an existing results folder: finished cases are not run again
  bool quiet       = false; // no progress of the single runs
  bool list        = false; // say what the cases are and which are finished, run nothing
  bool collect     = false; // table, pictures and report of what is finished, run nothing
  bool dry_run     = false; // what every case will cost, run nothing
  std::string only = ""; // number, from 1, or name of the only case to run; "": all. Without table
  int n_jobs       = 1;  // cases at a time, each in a process of its own
};

struct StudyEnd
{
  int n_failed     = 0;
  bool interrupted = false; // and some cases have not run
};

/**
 * Runs every case of the study, each into its own folder, and writes study.csv after each; with the
 * plates' extents where the grid makes them differ (study_plates.h). A case
 * that fails is kept in the table with its reason and does not stop the others. A finished case is
 * one whose summary says so and whose parameters are those of now. With a reference, comparison.csv
 * and comparison_paths.csv follow (comparison.h), and accuracy.png.
 *
 * With a limit the study grows: bisection adds cases until the bracket is as narrow as asked for;
 * limits.csv has it. What is finished counts as in any study.
 *
 * A finished case is run again, and said why, if its summary is of another version, of other
 * parameters or changed. SIGINT and SIGTERM end the study after the present step.
 *
 * Collective. Throws InputError or FileError for the study
 * itself.
 */
StudyEnd run_study(MPI_Comm communicator, const std::string &path, const StudyOptions &options);
} // namespace ricochet
