// SPDX-License-Identifier: LGPL-2.1-or-later
// Physical quantities as text: a number with its unit, "30 mm", "5.9 GPa", "0.01 s/m", converted to
// SI. A number without a unit is plain only where a plain number is meant.
#pragma once

#include "ricochet/base/dimension.h"

#include <optional>
#include <string>
#include <vector>

namespace ricochet
{
/// "a length", "an angle".
std::string dimension_name(Dimension dimension);

/// The units a quantity of this dimension can be written in, "um, mm, cm, m or in"; "" for a
/// number.
std::string unit_names(Dimension dimension);

/// The same one by one; none for a number.
std::vector<std::string> units_of(Dimension dimension);

/// What parse_quantity() finds.
struct ParsedQuantity
{
  double value;        // in SI; meaningless if there is a problem
  std::string problem; // why the text is not such a quantity, a sentence; "" if it is one
};

/**
 * Converts one number with its unit to SI. Blanks between them are optional; "kg/m^3" and "µs" are
 * understood like "kg/m3" and "us". Infinite numbers and NaN are a problem.
 */
ParsedQuantity parse_quantity(const std::string &text, Dimension dimension, Limit limit);

/// What parse_quantities() finds; values is empty if there is a problem.
struct ParsedQuantities
{
  std::vector<double> values; // in SI
  std::string problem;        // as in ParsedQuantity
};
/// The same for n_values quantities (0: one or more) separated by commas.
ParsedQuantities parse_quantities(const std::string &text, Dimension dimension, Limit limit,
                                  unsigned int n_values);

/// A number with whatever unit follows it.
struct FreeQuantity
{
  double number;       // as written
  std::string unit;    // as units_of() spells it; "" for a plain number
  double in_si;        // of one unit
  Dimension dimension; // of the unit
};
/// Nothing if the text is no such number, or the unit is unknown.
std::optional<FreeQuantity> parse_free_quantity(const std::string &text);
} // namespace ricochet
