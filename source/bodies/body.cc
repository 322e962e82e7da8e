// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/body.h"

#include <cmath>

namespace ricochet
{
Momenta &Momenta::operator+=(const Momenta &other)
{
  linear += other.linear;
  angular += other.angular;
  return *this;
}

Momenta operator*(const double factor, const Momenta &momenta)
{
  return {factor * momenta.linear, factor * momenta.angular};
}

double Vibration::noise(const Vector3 &place, const int component)
{
  return std::sin(12.9898 * place[0] + 78.233 * place[1] + 37.719 * place[2] + 4.1 * component);
}
} // namespace ricochet
