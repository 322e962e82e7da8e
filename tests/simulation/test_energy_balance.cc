// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/energy_balance.h"

#include <gtest/gtest.h>

#include <cstring>

namespace ricochet::tests
{
namespace
{
TEST(EnergyBalance, ResidualCountsEveryTermOnce)
{
  // Also a term that is added and forgotten in residual().
  constexpr int n_terms = sizeof(EnergyBalance) / sizeof(double);
  for (int i = 0; i < n_terms; ++i)
  {
    double terms[n_terms] = {};
    terms[i]              = 8.;
    EnergyBalance balance;
    std::memcpy(&balance, terms, sizeof balance);
    EXPECT_EQ(balance.residual(), balance.initial + balance.drive > 0. ? 8. : -8.)
        << "term number " << i;
  }
}
} // namespace
} // namespace ricochet::tests
