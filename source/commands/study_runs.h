// SPDX-License-Identifier: LGPL-2.1-or-later
// The cases of a study on their way: what is finished, what runs, what is known of each.
#pragma once

#include "study.h"
#include "study_case.h"
#include "study_table.h"

#include <memory>

namespace ricochet
{
class StudyRuns
{
public:
  StudyRuns(MPI_Comm communicator, StudyParameters parameters, const StudyOptions &options);

  /// Throws FileError unless the folder is new, empty or may hold results.
  void prepare_folder();
  /// Looks at what is finished, and adds what a limit has been found to need by it.
  void look_back();
  /// One of them alone, without tables and report.
  StudyEnd run_one();
  /// All of them, with study.csv and study.json after each.
  StudyEnd run_cases();
  const StudyParameters &parameters() const { return parameters_; }
  const std::filesystem::path &directory() const { return directory_; }
  const StudyTable &table() const { return *table_; }
  /// Of all cases; null if there is none, or it failed. Of the first rank.
  const std::vector<nlohmann::ordered_json> &summaries() const { return summaries_; }
  /// As in the table, of all cases; "": not looked at yet.
  const std::vector<std::string> &statuses() const { return statuses_; }

private:
  /// A table for as many cases as there are now.
  void take_over_cases();
  /// What the limits need next, as the first rank, which has the summaries, finds.
  void add_next_cases();
  void tell(std::size_t i, const std::string &remark) const;
  /// From 0. Throws InputError.
  std::size_t number_of(const std::string &wanted) const;
  void keep(std::size_t i, const CaseEnd &end);
  void write_tables() const;
  /// Returns whether the user has interrupted it.
  bool run_in_turn(std::size_t first);
  /// The same, several at a time; what is finished starts no process.
  bool run_at_once(std::size_t first);
  CaseEnd run_case(std::size_t i) const;

  MPI_Comm communicator_;
  StudyParameters parameters_; // to which a limit adds cases
  StudyOptions options_;
  std::filesystem::path directory_;
  bool speaks_;
  std::unique_ptr<StudyTable> table_;
  std::vector<nlohmann::ordered_json> summaries_;
  std::vector<std::string> statuses_;
};
} // namespace ricochet
