// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers as people read them.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

namespace ricochet
{
/// With so many digits behind the point: "12.30".
inline std::string with_decimals(const double value, const int n)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(n) << value;
  return text.str();
}

/// With so many significant digits at most, large and small ones with a power of ten: "12.3",
/// "1.2e-05".
inline std::string with_digits(const double value, const int n)
{
  std::ostringstream text;
  text << std::setprecision(n) << value;
  return text.str();
}

/// Always with a power of ten and so many digits behind the point: "1.2e-05".
inline std::string with_exponent(const double value, const int n)
{
  std::ostringstream text;
  text << std::scientific << std::setprecision(n) << value;
  return text.str();
}

/// A number from 0, filled up with zeros to so many digits: "0012".
inline std::string with_zeros(const long number, const int n)
{
  std::ostringstream text;
  text << std::setfill('0') << std::setw(n) << number;
  return text.str();
}
} // namespace ricochet
