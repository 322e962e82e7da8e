// SPDX-License-Identifier: LGPL-2.1-or-later
// A study of convergence: errors of every grid against one of them, and the observed orders.
#pragma once

#include "ricochet/scene/study_file.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ricochet
{
struct Convergence
{
  std::string csv;    // convergence.csv: a row per grid and set of values of the other axes
  std::string orders; // convergence_orders.csv: a row per quantity and such set
  std::string text;   // both for the eye
};

/// summaries[i] is that of case i; what is null, failed or interrupted does not take part. Reads
/// the cases' histories in the folder of the study, for their paths. Throws FileError.
Convergence converge(const StudyParameters &study,
                     const std::vector<nlohmann::ordered_json> &summaries,
                     const std::filesystem::path &directory);
} // namespace ricochet
