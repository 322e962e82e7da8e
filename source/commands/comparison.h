// SPDX-License-Identifier: LGPL-2.1-or-later
// Ensembles of runs against an ensemble of a reference: do they end alike, how far apart are the
// paths and exit speeds, what do they cost? Fracture is sensitive, so a single run says little; and
// exit speeds may have two humps, so they are given as median and range.
#pragma once

#include "ricochet/scene/study_file.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace ricochet
{
/// The summaries (summary.json) of runs that differ in the ensemble's axes only.
using Ensemble = std::vector<nlohmann::ordered_json>;

/// How far an ensemble is from its reference at one stated time.
struct PathError
{
  double stated_time; // [us]
  double path;        // of the reference, mean [mm]
  double error;       // distance of the mean positions of the centroid, in reference paths
  double low, high;   // of the single runs: distance from the reference's mean position, likewise
  double scatter;     // of the reference: the same for the farthest of its own runs; or not a
                      // number if it has a single run
};

/**
 * The errors at all stated times (positions of the summaries) that every run of both ensembles
 * has reached, earliest first. Empty if there are none, or one ensemble is empty.
 */
std::vector<PathError> path_errors(const Ensemble &runs, const Ensemble &reference);

/**
 * One row of comparison.csv without the names. What cannot be said is null:
 * the path without a common time, the outcome if the reference has no majority or is undecided, the
 * exit speed of projectiles that have not left. same_outcome is the share of runs that end like
 * most runs of the reference.
 */
nlohmann::ordered_json compare(const Ensemble &runs, const Ensemble &reference);

struct Comparison
{
  std::string csv;   // comparison.csv: one row per ensemble
  std::string paths; // comparison_paths.csv: one row per ensemble and stated time
  std::string text;  // for the eye
};

/// Compares every scene of the study with its reference; summaries[i] is that of case i. What is
/// null, failed or interrupted does not take part.
Comparison compare_scenes(const StudyParameters &study,
                          const std::vector<nlohmann::ordered_json> &summaries);
} // namespace ricochet
