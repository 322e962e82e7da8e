// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/bodies/body.h"

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
} // namespace ricochet
