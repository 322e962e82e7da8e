// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers as people read them.
#pragma once

#include <algorithm>
#include <cmath>
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

/// With so many significant digits at least, whole numbers in full: "1234", "12.3", "0.0123". Every
/// value is as precise as another, whatever its unit is good for.
inline std::string with_precision(const double value, const int n)
{
  const double size = std::abs(value);
  const bool plain  = std::isfinite(value) && value != 0.;
  return with_decimals(
      value, plain ? std::max(0, n - 1 - static_cast<int>(std::floor(std::log10(size)))) : 0);
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
