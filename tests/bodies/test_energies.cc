// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/energies.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <set>
#include <string>

namespace ricochet::tests
{
namespace
{
constexpr int n_terms = sizeof(Energies) / sizeof(double);

/// Every term another number, also those that are yet to come.
Energies numbered(const double factor)
{
  double terms[n_terms];
  for (int i = 0; i < n_terms; ++i)
    terms[i] = factor * (i + 1);
  Energies energies;
  std::memcpy(&energies, terms, sizeof energies);
  return energies;
}

void expect_numbered(const Energies &energies, const double factor)
{
  double terms[n_terms];
  std::memcpy(terms, &energies, sizeof energies);
  for (int i = 0; i < n_terms; ++i)
    EXPECT_EQ(terms[i], factor * (i + 1)) << "term number " << i;
}

TEST(Energies, SumsAndMultiplesOfEnergiesForgetNoTerm)
{
  Energies sum = numbered(1.);
  sum += numbered(2.);
  expect_numbered(sum, 3.);
  expect_numbered(0.5 * sum, 1.5);
  const auto &e = sum;
  EXPECT_EQ(e.held(), e.kinetic + e.strain + e.hourglass);
}

TEST(Energies, EveryTermHasARowOfItsOwn)
{
  EXPECT_EQ(static_cast<int>(std::size(energy_rows)), n_terms);
  std::set<std::string> names;
  Energies energies;
  for (const auto &row : energy_rows)
  {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(energies.*row.value, 0.) << row.name << " has been here before";
    energies.*row.value = 1.;
  }
}
} // namespace
} // namespace ricochet::tests
