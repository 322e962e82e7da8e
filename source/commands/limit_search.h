// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for a limit by bisection: what the runs so far tell, and which one is next.
#pragma once

#include "ricochet/scene/study_file.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet
{
/// The search under one set of values of the other axes.
struct LimitSearch
{
  std::string group; // "base, 30 deg"; "" if there is one alone
  std::size_t like;  // number of one of its cases
  int n_runs = 0;    // that have told an outcome
  double low, high;  // the bracket so far
  std::string low_outcome, high_outcome;
  std::optional<double> next = {};    // value that has to be run; none: it has ended, or waits
  bool is_found              = false; // the bracket is as narrow as asked for
  std::string reason         = "";    // why it goes no further, if it is not found
};

/// From the summaries of the study's cases, null where there is none (yet). A value that is needed
/// and is already a case of the study is not asked for again.
std::vector<LimitSearch> limit_searches(const StudyParameters &study,
                                        const std::vector<nlohmann::ordered_json> &summaries);

/// limits.csv: a row per search.
std::string limits_csv(const StudyParameters &study, const std::vector<LimitSearch> &searches);
/// The same for scripts, in study.json.
nlohmann::ordered_json limits_json(const StudyParameters &study,
                                   const std::vector<LimitSearch> &searches);
/// A sentence per search.
std::string limits_text(const StudyParameters &study, const std::vector<LimitSearch> &searches);
} // namespace ricochet
