// SPDX-License-Identifier: LGPL-2.1-or-later
// Ensembles of runs against an ensemble of a reference: do they end alike, how far apart are the
// paths and exit speeds, what do they cost? Fracture is sensitive, so a single run says little; and
// exit speeds may have two humps, so they are given as median and range.
#pragma once

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

/// The names of the values that compare() returns, in their order.
extern const std::vector<std::string> comparison_columns;

/// Of a share; null if it is not finite.
nlohmann::ordered_json percent(double share);
} // namespace ricochet
