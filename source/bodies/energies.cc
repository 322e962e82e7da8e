// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/energies.h"

namespace ricochet
{
Energies &Energies::operator+=(const Energies &other)
{
  for (const auto &row : energy_rows)
    this->*row.value += other.*row.value;
  return *this;
}

double Energies::held() const
{
  double sum = 0.;
  for (const auto &row : energy_rows)
    if (row.account == EnergyAccount::held)
      sum += this->*row.value;
  return sum;
}

Energies operator*(const double factor, const Energies &energies)
{
  Energies result;
  for (const auto &row : energy_rows)
    result.*row.value = factor * energies.*row.value;
  return result;
}
} // namespace ricochet
