// SPDX-License-Identifier: LGPL-2.1-or-later
// A sum of doubles without rounding, whatever their order and on whatever rank they are: for sums
// over what ranks share in other ways than by lattice planes (peridynamics/plane_sums.h does those
// in a tenth of the time). All doubles are whole multiples of the smallest one, so the sum is kept
// as a whole number (Neal 2015, Fast exact summation using small and large superaccumulators,
// arXiv:1505.05571) and rounded once, in the end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mpi.h>

namespace ricochet
{
class ExactSum
{
public:
  /// A term. One that is not finite makes the sum so.
  void add(double term);
  /// The double next to the sum.
  double value() const;

  /// Each sum becomes that over all ranks. Collective.
  static void add_ranks(MPI_Comm communicator, ExactSum *sums, std::size_t n);

private:
  static constexpr int digit_bits = 32;
  // The smallest double is 2^-1074, the largest below 2^1024; two digits more for carries.
  static constexpr int lowest_bit = -1074;
  static constexpr int n_digits   = (1024 - lowest_bit) / digit_bits + 3;

  void carry();

  /// The sum is digits[i] 2^(32 i - 1074); between two carries they may be of any sign and size.
  std::array<std::int64_t, n_digits> digits_{};
  double not_finite_     = 0.; // sum of what is not, else zero
  std::int32_t n_before_ = 0;  // terms since the last carry
};

/// Sums over all ranks. Collective.
template <std::size_t n>
std::array<double, n> totals(const MPI_Comm communicator, std::array<ExactSum, n> sums)
{
  ExactSum::add_ranks(communicator, sums.data(), n);
  std::array<double, n> values;
  for (std::size_t i = 0; i < n; ++i)
    values[i] = sums[i].value();
  return values;
}

/// Of one sum, likewise.
inline double total(const MPI_Comm communicator, const ExactSum &sum)
{
  return totals<1>(communicator, {sum})[0];
}
} // namespace ricochet
