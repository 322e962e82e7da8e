// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/body.h"

#include <gtest/gtest.h>

#include <cstring>

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

TEST(Body, SumsAndMultiplesOfEnergiesForgetNoTerm)
{
  Energies sum = numbered(1.);
  sum += numbered(2.);
  expect_numbered(sum, 3.);
  expect_numbered(0.5 * sum, 1.5);
  const auto &e = sum;
  EXPECT_EQ(e.held(), e.kinetic + e.strain + e.hourglass);
}

TEST(Body, MomentaAddUp)
{
  Momenta sum{Vector3(1., 2., 3.), Vector3(4., 5., 6.)};
  sum += 2. * sum;
  EXPECT_EQ(sum.linear, Vector3(3., 6., 9.));
  EXPECT_EQ(sum.angular, Vector3(12., 15., 18.));
}
} // namespace
} // namespace ricochet::tests
