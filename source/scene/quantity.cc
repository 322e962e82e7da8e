// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/scene/quantity.h"

#include "ricochet/scene/text_tools.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace ricochet
{
namespace
{
struct Unit
{
  Dimension dimension;
  const char *name;
  double in_si;
};

constexpr double inch = 0.0254, foot = 0.3048, degree = 3.14159265358979323846 / 180.;

constexpr Unit units[] = {
    {Dimension::length, "um", 1e-6},
    {Dimension::length, "mm", 1e-3},
    {Dimension::length, "cm", 1e-2},
    {Dimension::length, "m", 1.},
    {Dimension::length, "in", inch},
    {Dimension::time, "ns", 1e-9},
    {Dimension::time, "us", 1e-6},
    {Dimension::time, "ms", 1e-3},
    {Dimension::time, "s", 1.},
    {Dimension::time, "min", 60.},
    {Dimension::time, "h", 3600.},
    {Dimension::mass, "mg", 1e-6},
    {Dimension::mass, "g", 1e-3},
    {Dimension::mass, "kg", 1.},
    {Dimension::angle, "deg", degree},
    {Dimension::angle, "rad", 1.},
    {Dimension::angular_velocity, "rad/s", 1.},
    {Dimension::angular_velocity, "rev/s", 360. * degree},
    {Dimension::angular_velocity, "rpm", 6. * degree},
    {Dimension::speed, "m/s", 1.},
    {Dimension::speed, "km/s", 1e3},
    {Dimension::speed, "mm/us", 1e3},
    {Dimension::speed, "ft/s", foot},
    {Dimension::slowness, "s/m", 1.},
    {Dimension::slowness, "ms/m", 1e-3},
    {Dimension::slowness, "us/mm", 1e-3},
    {Dimension::density, "kg/m3", 1.},
    {Dimension::density, "g/cm3", 1e3},
    {Dimension::stress, "Pa", 1.},
    {Dimension::stress, "kPa", 1e3},
    {Dimension::stress, "MPa", 1e6},
    {Dimension::stress, "GPa", 1e9},
    {Dimension::surface_energy, "J/m2", 1.},
    {Dimension::surface_energy, "kJ/m2", 1e3},
    {Dimension::surface_energy, "N/m", 1.},
};

void replace_all(std::string &text, const std::string &from, const std::string &to)
{
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// One spelling for what word processors and keyboards write in several ways.
std::string plain_unit(std::string unit)
{
  replace_all(unit, "\u00b5", "u"); // micro sign
  replace_all(unit, "\u03bc", "u"); // Greek mu
  replace_all(unit, "\u00b0", "deg");
  replace_all(unit, "\u00b2", "2");
  replace_all(unit, "\u00b3", "3");
  replace_all(unit, "^", "");
  replace_all(unit, " ", "");
  return unit;
}

// Why `unit` is not one of the dimension's units.
std::string unit_problem(const std::string &unit, const Dimension dimension)
{
  for (const Unit &other : units)
    if (const std::string name = dimension_name(other.dimension); unit == other.name)
      return in_quotes(unit) + " is a unit of " + name.substr(name.find(' ') + 1) + ".";
  for (const auto &name : units_of(dimension))
    if (lower_case(name) == lower_case(unit))
      return "There is no unit " + in_quotes(unit) + "; did you mean '" + name + "'?";
  return "There is no unit " + in_quotes(unit) + ".";
}

std::string limit_problem(const double value, const Limit limit)
{
  switch (limit)
  {
    case Limit::any:
      return "";
    case Limit::positive:
      return value > 0. ? "" : "The value must be above 0.";
    case Limit::not_negative:
      return value >= 0. ? "" : "The value must not be negative.";
    case Limit::fraction:
      return value >= 0. && value <= 1. ? "" : "The value must lie between 0 and 1.";
  }
  return "";
}
} // namespace

std::string dimension_name(const Dimension dimension)
{
  switch (dimension)
  {
    case Dimension::number:
      return "a number";
    case Dimension::length:
      return "a length";
    case Dimension::time:
      return "a time";
    case Dimension::mass:
      return "a mass";
    case Dimension::angle:
      return "an angle";
    case Dimension::angular_velocity:
      return "an angular velocity";
    case Dimension::speed:
      return "a speed";
    case Dimension::slowness:
      return "an inverse speed";
    case Dimension::density:
      return "a density";
    case Dimension::stress:
      return "a stress";
    case Dimension::surface_energy:
      return "an energy per area";
  }
  return "";
}

std::vector<std::string> units_of(const Dimension dimension)
{
  std::vector<std::string> names;
  for (const Unit &unit : units)
    if (unit.dimension == dimension)
      names.push_back(unit.name);
  return names;
}

std::string unit_names(const Dimension dimension)
{
  return joined(units_of(dimension), " or ");
}

ParsedQuantity parse_quantity(const std::string &text, const Dimension dimension, const Limit limit)
{
  constexpr double none     = std::numeric_limits<double>::signaling_NaN();
  const std::string trimmed = squeezed(text);
  if (trimmed.empty())
    return {none, "There is no value."};

  // std::from_chars does not depend on the locale, but knows no leading plus sign.
  const char *const begin = trimmed.data() + (trimmed[0] == '+' ? 1 : 0);
  const char *const end   = trimmed.data() + trimmed.size();
  double number           = 0.;
  const auto result       = std::from_chars(begin, end, number);
  if (result.ec == std::errc::invalid_argument)
    return {none, in_quotes(trimmed) + " does not begin with a number."};
  if (result.ec == std::errc::result_out_of_range || !std::isfinite(number))
    return {none, in_quotes(trimmed) + " is not a finite number."};

  const std::string unit = plain_unit(std::string(result.ptr, end));
  if (dimension == Dimension::number)
  {
    if (!unit.empty())
      return {none,
              "The value is a plain number without unit, but " + in_quotes(unit) + " follows."};
    return {number, limit_problem(number, limit)};
  }
  if (unit.empty())
    return {none, "The unit is missing."};
  for (const Unit &known : units)
    if (known.dimension == dimension && unit == known.name)
    {
      const double value = number * known.in_si;
      if (!std::isfinite(value))
        return {none, in_quotes(trimmed) + " is not a finite number."};
      return {value, limit_problem(value, limit)};
    }
  return {none, unit_problem(unit, dimension)};
}

std::optional<FreeQuantity> parse_free_quantity(const std::string &text)
{
  const std::string trimmed = squeezed(text);
  if (trimmed.empty())
    return {};
  const char *const end = trimmed.data() + trimmed.size();
  double number         = 0.;
  const auto result = std::from_chars(trimmed.data() + (trimmed[0] == '+' ? 1 : 0), end, number);
  if (result.ec != std::errc() || !std::isfinite(number))
    return {};
  const std::string unit = plain_unit(std::string(result.ptr, end));
  if (unit.empty())
    return FreeQuantity{number, "", 1., Dimension::number};
  for (const Unit &known : units)
    if (unit == known.name)
      return FreeQuantity{number, unit, known.in_si, known.dimension};
  return {};
}

ParsedQuantities parse_quantities(const std::string &text, const Dimension dimension,
                                  const Limit limit, const unsigned int n_values)
{
  const auto parts = split(text, ',');
  if (n_values > 0 && parts.size() != n_values && !(n_values == 1 && parts.size() == 2))
    return {{},
            (parts.size() == 1 ? "There is 1 value"
                               : "There are " + std::to_string(parts.size()) + " values") +
                " instead of " + std::to_string(n_values) + "."};
  if (n_values > 0 && parts.size() != n_values)
    return {{}, "One value is expected; the decimal mark is a point, not a comma."};

  ParsedQuantities result;
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    const auto parsed = parse_quantity(parts[i], dimension, limit);
    if (!parsed.problem.empty())
      return {{},
              (parts.size() == 1 ? "" : "Value " + std::to_string(i + 1) + ": ") + parsed.problem};
    result.values.push_back(parsed.value);
  }
  return result;
}
} // namespace ricochet
