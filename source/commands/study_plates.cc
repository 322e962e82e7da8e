// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study_plates.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"
#include "ricochet/scene/scene_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace ricochet
{
namespace
{
const std::array<const char *, 3> extents{"length", "width", "thickness"};
// What numbers in a file round to [m].
constexpr double same = 1e-9;

std::vector<PlateSize> sizes_of(const StudyCase &one)
{
  if (one.is_experiment)
    return {};
  try
  {
    return plate_sizes(read_scene(one.file));
  }
  catch (const InputError &error)
  {
    throw InputError("Case " + one.name + ": " + error.what());
  }
}
} // namespace

StudyPlates::StudyPlates(const StudyParameters &study) : study_(study)
{
  std::size_t n_plates = 0;
  for (const auto &one : study.cases)
  {
    sizes_.push_back(sizes_of(one));
    n_plates = std::max(n_plates, sizes_.back().size());
  }
  for (std::size_t plate = 0; plate < n_plates; ++plate)
    for (int axis = 0; axis < 3; ++axis)
      if (differs({plate, axis}))
      {
        differences_.push_back({plate, axis});
        columns_.push_back("plate_" + std::to_string(plate + 1) + "_" + extents[axis] + "_mm");
      }
}

/// Whether two cases ask for the same and do not compute the same.
bool StudyPlates::differs(const Difference &one) const
{
  for (const auto &a : sizes_)
    for (const auto &b : sizes_)
      if (one.plate < std::min(a.size(), b.size()))
      {
        const auto apart = (a[one.plate].computed - b[one.plate].computed)[one.axis],
                   asked = (a[one.plate].asked - b[one.plate].asked)[one.axis];
        if (std::abs(asked) < same && std::abs(apart) > same)
          return true;
      }
  return false;
}

std::vector<nlohmann::ordered_json> StudyPlates::row(const std::size_t number) const
{
  std::vector<nlohmann::ordered_json> values;
  for (const auto &[plate, axis] : differences_)
    if (plate < sizes_[number].size())
      values.emplace_back(sizes_[number][plate].computed[axis] / units::mm);
    else
      values.emplace_back(nullptr);
  return values;
}

std::string StudyPlates::warning() const
{
  if (differences_.empty())
    return "";
  std::string text = "cases that ask for the same plates compute different ones, because extents "
                     "are multiples of the grid spacing or of the largest elements. What differs "
                     "between such cases is not the grid alone:\n";
  std::set<std::size_t> plates;
  for (const auto &one : differences_)
    plates.insert(one.plate);
  for (const std::size_t plate : plates)
  {
    std::set<std::string> told;
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (plate < sizes_[i].size())
      {
        const auto &size       = sizes_[i][plate];
        const std::string line = "  plate " + std::to_string(plate + 1) + ": " +
                                 size_text(size.computed) + " for " + size_text(size.asked);
        if (told.insert(line).second)
          text += line + ", first in " + study_.cases[i].name + "\n";
      }
  }
  return text + "Choose sizes that are multiples of all spacings; the table has the extents.";
}
} // namespace ricochet
