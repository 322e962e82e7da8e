// SPDX-License-Identifier: LGPL-2.1-or-later
// A run's history.csv, read again to be compared.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ricochet
{
/// The columns by their names without units, and the path.
using HistoryRows = std::map<std::string, std::vector<double>>;

/// Throws FileError.
HistoryRows read_history_rows(const std::filesystem::path &path);

/// Linearly between the rows; nothing outside of the history.
std::optional<double> interpolated(const std::vector<double> &times,
                                   const std::vector<double> &values, double time);
} // namespace ricochet
