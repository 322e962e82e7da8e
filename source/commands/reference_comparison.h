// SPDX-License-Identifier: LGPL-2.1-or-later
// A run's history held against somebody else's data: relative error at each of its times and the
// root of the mean squared error, as published comparisons with experiments state them.
#pragma once

#include "reference_data.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <vector>

namespace ricochet
{
/**
 * The field `reference_data` of the summary: file, source, and per column its name, unit, "rmse" in
 * that unit, and per time "time_us", "kind", "wanted", "error_bar", "found" and "relative_error",
 * (found - wanted) / |wanted|. What was not reached, and what has no such error, is null.
 *
 * Reads history.csv of the folder; between its rows values are interpolated linearly. Throws
 * FileError.
 */
nlohmann::ordered_json compare_with_data(const std::filesystem::path &directory,
                                         const ReferenceData &data);

/// In one line per column, for the user; "" if the summary has no such field.
std::string describe_reference_data(const nlohmann::ordered_json &summary);

/// Columns of a study's table, "reference_rmse_path_mm" and, with few times,
/// "reference_error_path_94_us_percent".
std::vector<std::string> reference_columns(const ReferenceData &data);

/// The value of the `wanted` such column in a summary, or null.
nlohmann::ordered_json reference_value(const nlohmann::ordered_json &summary,
                                       const std::string &wanted);
} // namespace ricochet
