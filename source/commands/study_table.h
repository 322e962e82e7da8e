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

  /// Of the case of that number, whose summary may be null. Cases come in their order.
  void add(std::size_t number, const nlohmann::ordered_json &summary, const std::string &status);

  std::string csv() const { return table_.csv(); }
  /// With labels instead of names and axes.
  std::string text() const { return shown_.text(); }
  /// study.json: title, axes, and of every case its name, label, axes' values and status.
  std::string json() const { return record_.dump(2) + "\n"; }

  /// Whether all cases are stability experiments, whose table is a map.
  bool is_map() const { return is_map_; }
  /// What the user has to know about the plates, or "".
  std::string warning() const { return plates_.warning(); }

private:
  const StudyParameters &study_;
  StudyPlates plates_;
  bool is_map_;
  std::vector<std::string> fields_; // of the summaries
  Table table_, shown_;
  nlohmann::ordered_json record_;
};
} // namespace ricochet
