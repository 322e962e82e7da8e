// SPDX-License-Identifier: LGPL-2.1-or-later
// The plates of a study's cases as they are computed: a study of the grid compares different plates
// if their extents are multiples of one spacing and not of the other.
#pragma once

#include "ricochet/scene/study_file.h"
#include "ricochet/simulation/plate_size.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace ricochet
{
class StudyPlates
{
public:
  /// Reads all cases that are scenes. Throws InputError, naming the case, if the grid would make
  /// another plate of one, see lattice_points().
  explicit StudyPlates(const StudyParameters &study);

  /// Fields of the summary, "plate_1_length_mm": extents that cases ask for alike and that differ.
  const std::vector<std::string> &columns() const { return columns_; }
  /// Their values in a case, by its number in the study; null where it has no such plate [mm].
  std::vector<nlohmann::ordered_json> row(std::size_t number) const;
  /// What the user has to know if there are such columns, else empty.
  std::string warning() const;

private:
  struct Difference
  {
    std::size_t plate; // from 0
    int axis;          // of PlateSize
  };
  bool differs(const Difference &one) const;

  const StudyParameters &study_;
  std::vector<std::vector<PlateSize>> sizes_; // of each case; none: an experiment of stability
  std::vector<Difference> differences_;
  std::vector<std::string> columns_;
};
} // namespace ricochet
