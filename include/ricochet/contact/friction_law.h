// SPDX-License-Identifier: LGPL-2.1-or-later
// Interface of a Coulomb friction law: the coefficient as a function of the sliding speed.
// A new law is one header beside this one, one line in contact/friction_laws.h and one in
// tests/support/laws.h; doc/adding_a_law.md shows it.
#pragma once

#include "ricochet/base/entry_row.h"

namespace ricochet
{
class FrictionLaw
{
public:
  virtual ~FrictionLaw() = default;

  /// Friction coefficient [-] at the relative tangential speed [m/s], speed >= 0.
  virtual double coefficient(double speed) const = 0;
};

// Constants that several laws have, each for its own member.

/// mu_0, at rest [-].
template <class Parameters>
constexpr EntryRow<Parameters> static_friction(double Parameters::*member)
{
  return {"Static friction",   member, Dimension::number,
          Limit::not_negative, "0.5",  "Friction coefficient at rest"};
}

/// mu at high speed [-].
template <class Parameters>
constexpr EntryRow<Parameters> kinetic_friction(double Parameters::*member)
{
  return {"Kinetic friction",  member, Dimension::number,
          Limit::not_negative, "0.05", "Friction coefficient at high speed"};
}

/// gamma, how fast it falls from the one to the other [s/m].
template <class Parameters>
constexpr EntryRow<Parameters> friction_decay(double Parameters::*member)
{
  return {"Friction decay",    member,     Dimension::slowness,
          Limit::not_negative, "0.01 s/m", "Decay of the coefficient with the speed"};
}
} // namespace ricochet
