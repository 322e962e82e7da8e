// SPDX-License-Identifier: LGPL-2.1-or-later
// Cases of a study side by side, each in a process of its own.
#pragma once

#include "study_case.h"

#include <functional>

namespace ricochet
{
/**
 * Runs the cases of these numbers, at most n_jobs at a time, by `ricochet study FILE --case NAME`,
 * and prints their lines, each with the case's number in front. `ended` hears of every case that
 * has been started. Returns whether the user has interrupted it. For a single rank.
 */
bool run_side_by_side(const StudyParameters &study, const std::vector<std::size_t> &numbers,
                      int n_jobs, bool quiet,
                      const std::function<void(std::size_t, const CaseEnd &)> &ended);
} // namespace ricochet
