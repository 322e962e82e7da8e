// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/base/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace ricochet
{
void ExactSum::add(const double term)
{
  constexpr std::int32_t most_terms = 1 << 30; // of less than 2^32 in each digit
  std::uint64_t bits;
  std::memcpy(&bits, &term, sizeof bits);
  const int exponent = static_cast<int>(bits >> 52) & 0x7ff;
  if (exponent == 0x7ff)
  {
    not_finite_ += term;
    return;
  }
  // Subnormal numbers have the exponent of the smallest normal ones and no leading 1.
  const std::uint64_t mantissa =
      (bits & ((std::uint64_t(1) << 52) - 1)) | (exponent > 0 ? std::uint64_t(1) << 52 : 0);
  const int shift = exponent > 0 ? exponent - 1 : 0;
  const int first = shift / digit_bits, within = shift % digit_bits;
  // 53 bits from `within` on: at most 84, three digits.
  const std::uint64_t low = mantissa << within, mask = 0xffffffffu,
                      high    = within > 0 ? mantissa >> (64 - within) : 0;
  const std::int64_t parts[3] = {static_cast<std::int64_t>(low & mask),
                                 static_cast<std::int64_t>(low >> digit_bits),
                                 static_cast<std::int64_t>(high)};
  const bool negative         = (bits >> 63) != 0;
  for (int i = 0; i < 3; ++i)
    digits_[first + i] += negative ? -parts[i] : parts[i];
  if (++n_before_ == most_terms)
    carry();
}

/// All digits but the highest are between 0 and 2^32 - 1 then, which they can be in one way only.
void ExactSum::carry()
{
  for (int i = 0; i + 1 < n_digits; ++i)
  {
    const std::int64_t above = digits_[i] >> digit_bits; // rounds down
    digits_[i] -= above * (std::int64_t(1) << digit_bits);
    digits_[i + 1] += above;
  }
  n_before_ = 0;
}

double ExactSum::value() const
{
  if (not_finite_ != 0.) // true of nan, too
    return not_finite_;
  ExactSum sum = *this;
  sum.carry();
  auto &digits        = sum.digits_;
  const bool negative = digits[n_digits - 1] < 0;
  if (negative)
  {
    for (auto &digit : digits)
      digit = -digit;
    sum.carry();
  }
  int top = n_digits - 1;
  while (top > 0 && digits[top] == 0)
    --top;
  if (top < 2) // below 2^-978: few bits, and 64 of them exact
    return (negative ? -1. : 1.) *
           std::ldexp(static_cast<double>(static_cast<std::uint64_t>(digits[1]) << digit_bits |
                                          static_cast<std::uint64_t>(digits[0])),
                      lowest_bit);
  // The leading 64 bits; what lies below them decides ties only.
  auto leading = static_cast<std::uint64_t>(digits[top]) << digit_bits |
                 static_cast<std::uint64_t>(digits[top - 1]);
  auto rest = static_cast<std::uint64_t>(digits[top - 2]) << digit_bits;
  int shift = 0;
  for (; (leading >> 63) == 0; ++shift)
  {
    leading = leading << 1 | rest >> 63;
    rest <<= 1;
  }
  bool more = rest != 0;
  for (int i = 0; i + 2 < top; ++i)
    more = more || digits[i] != 0;
  return (negative ? -1. : 1.) * std::ldexp(static_cast<double>(leading | (more ? 1 : 0)),
                                            lowest_bit + digit_bits * (top - 1) - shift);
}

void ExactSum::add_ranks(const MPI_Comm communicator, ExactSum *const sums, const std::size_t n)
{
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);
  if (n_ranks == 1)
    return;
  std::vector<std::int64_t> digits;
  std::vector<double> not_finite;
  for (std::size_t k = 0; k < n; ++k)
  {
    sums[k].carry();
    digits.insert(digits.end(), sums[k].digits_.begin(), sums[k].digits_.end());
    not_finite.push_back(sums[k].not_finite_);
  }
  MPI_Allreduce(MPI_IN_PLACE, digits.data(), static_cast<int>(digits.size()), MPI_INT64_T, MPI_SUM,
                communicator);
  MPI_Allreduce(MPI_IN_PLACE, not_finite.data(), static_cast<int>(n), MPI_DOUBLE, MPI_SUM,
                communicator);
  for (std::size_t k = 0; k < n; ++k)
  {
    std::copy_n(digits.begin() + k * n_digits, n_digits, sums[k].digits_.begin());
    sums[k].not_finite_ = not_finite[k];
  }
}
} // namespace ricochet
