// SPDX-License-Identifier: LGPL-2.1-or-later
// The runs of a study of convergence, sorted by what is refined.
#pragma once

#include "ricochet/scene/study_file.h"

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace ricochet
{
/// The runs on one grid, which differ in the axes of the ensemble alone.
struct GridLevel
{
  std::size_t value; // number of the first axis' value
  double size;       // that value, in the unit of its column
  std::vector<std::size_t> cases = {};
  // At the time that all runs of the group have reached:
  Eigen::Vector3d place          = Eigen::Vector3d::Zero(); // mean [mm]
  std::vector<double> paths      = {};                      // of each run [mm]
};

/// The grids under one set of values of the other axes, from the coarsest to the finest.
struct GridGroup
{
  std::string scene, name;
  std::vector<GridLevel> levels = {};
  double time                   = 0.; // at which paths are compared [us]
};

/// Of all runs that have ended in order, with their paths, from the histories in the study's
/// folder. Throws FileError.
std::vector<GridGroup> grid_groups(const StudyParameters &study,
                                   const std::vector<nlohmann::ordered_json> &summaries,
                                   const std::filesystem::path &directory);
} // namespace ricochet
