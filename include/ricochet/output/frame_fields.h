// SPDX-License-Identifier: LGPL-2.1-or-later
// The fields of points and elements in the files for ParaView: name, unit, values and meaning of
// each in one row.
#pragma once

#include "ricochet/output/frame.h"

#include <string>
#include <vector>

namespace ricochet
{
/// A field of points and elements alike.
struct FrameField
{
  std::string name;          // in words, without the unit
  std::string unit;          // "-" if dimensionless
  unsigned int n_components; // 1, or 3 of a vector
  /// Component of a point, by its number in the frame; in that unit.
  double (*of_point)(const PointFrame &, std::size_t point, unsigned int component);
  /// The same of an element.
  double (*of_element)(const ElementFrame &, std::size_t element, unsigned int component);
  std::string meaning; // half a sentence, for the user

  /// As ParaView shows it, which knows no units: "velocity [m/s]".
  std::string title() const { return unit == "-" ? name : name + " [" + unit + "]"; }
};

/// In the order of the files.
const std::vector<FrameField> &frame_fields();
} // namespace ricochet
