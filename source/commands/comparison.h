// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of a study against its reference, as tables.
#pragma once

#include "ensemble.h"
#include "ricochet/scene/study_file.h"

namespace ricochet
{
struct Comparison
{
  std::string csv;    // comparison.csv: one row per ensemble
  std::string paths;  // comparison_paths.csv: one row per ensemble and stated time
  std::string text;   // for the eye
  std::string advice; // accuracy against cost, in sentences
};

/// Compares every scene of the study with its reference; summaries[i] is that of case i. What is
/// null, failed or interrupted does not take part.
Comparison compare_scenes(const StudyParameters &study,
                          const std::vector<nlohmann::ordered_json> &summaries);
} // namespace ricochet
