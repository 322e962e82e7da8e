// SPDX-License-Identifier: LGPL-2.1-or-later
// What has come out of a study: a row per case, for the eye, as CSV, and as JSON for the scripts
// that draw and report.
#pragma once

#include "ricochet/output/table.h"
#include "ricochet/scene/study_file.h"
#include "study_plates.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ricochet
{
class StudyTable
{
public:
  /// Without rows. Throws InputError if a column that the study asks for does not exist, or the
  /// grid would make another plate of one of a case.
  explicit StudyTable(const StudyParameters &study);

  /// The row of the case of that number, whose summary may be null; in any order, again too.
  void set(std::size_t number, const nlohmann::ordered_json &summary, const std::string &status);

  /// The rows that there are, in the order of the cases.
  std::string csv() const;
  /// With labels instead of names and axes.
  std::string text() const;
  /// study.json: title, axes, and of every case its name, label, axes' values and status. `more`:
  /// further fields.
  std::string json(const nlohmann::ordered_json &more) const;

  /// Whether all cases are stability experiments, whose table is a map.
  bool is_map() const { return is_map_; }
  /// What the user has to know about the plates, or "".
  std::string warning() const { return plates_.warning(); }

private:
  const StudyParameters &study_;
  StudyPlates plates_;
  bool is_map_;
  std::vector<std::string> fields_; // of the summaries
  nlohmann::ordered_json record_;
  std::vector<std::vector<nlohmann::ordered_json>> values_; // of each case; empty: no row yet
};
} // namespace ricochet
