// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/peridynamics/bond_history.h"

#include <gtest/gtest.h>

namespace ricochet::tests
{
namespace
{
TEST(BondHistory, KeepsANumberPerBondAndBranch)
{
  constexpr std::ptrdiff_t n_points = 24;
  constexpr std::size_t n_offsets = 5, n_branches = 3;
  // Binary fractions, exact in both precisions.
  const auto value = [](const std::ptrdiff_t p, const std::size_t k, const std::size_t b)
  { return 1. + double(p) + double(k) / 8. + double(b) / 64.; };
  for (const auto precision :
       {HistoryPrecision::single_precision, HistoryPrecision::double_precision})
  {
    BondHistory history(n_points, n_offsets, n_branches, precision);
    for (std::ptrdiff_t p = 0; p < n_points; ++p)
      for (std::size_t k = 0; k < n_offsets; ++k)
        for (std::size_t b = 0; b < n_branches; ++b)
        {
          EXPECT_EQ(history.read(p, k, b), 0.);
          history.write(p, k, b, value(p, k, b));
        }
    const bool is_single = precision == HistoryPrecision::single_precision;
    EXPECT_EQ(history.singles() != nullptr, is_single);
    EXPECT_EQ(history.doubles() != nullptr, !is_single);
    EXPECT_EQ(history.bytes_per_bond_and_branch(), is_single ? 4u : 8u);
    for (std::ptrdiff_t p = 0; p < n_points; ++p)
      for (std::size_t k = 0; k < n_offsets; ++k)
        for (std::size_t b = 0; b < n_branches; ++b)
        {
          ASSERT_EQ(history.read(p, k, b), value(p, k, b));
          // As kernels read it, see RelaxingBonds.
          const std::size_t at = ((p / 8 * n_offsets + k) * n_branches + b) * 8 + p % 8;
          ASSERT_EQ(is_single ? double(history.singles()[at]) : history.doubles()[at],
                    value(p, k, b));
        }
  }
}
} // namespace
} // namespace ricochet::tests
