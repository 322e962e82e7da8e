// SPDX-License-Identifier: LGPL-2.1-or-later
// The menu of friction laws: one line each.
#pragma once

#include "ricochet/base/exceptions.h"
#include "ricochet/contact/constant_friction.h"
#include "ricochet/contact/exponential_friction.h"
#include "ricochet/contact/hyperbolic_friction.h"

#include <memory>
#include <vector>

namespace ricochet
{
struct FrictionLawEntry
{
  const char *name;
  std::unique_ptr<FrictionLaw> (*make)(const FrictionParameters &);
};

template <class Law>
FrictionLawEntry friction_law_entry()
{
  return {Law::name, [](const FrictionParameters &parameters) -> std::unique_ptr<FrictionLaw> {
            return std::make_unique<Law>(parameters);
          }};
}

inline const std::vector<FrictionLawEntry> &friction_laws()
{
  static const std::vector<FrictionLawEntry> laws{
      friction_law_entry<ExponentialFriction>(),
      friction_law_entry<ConstantFriction>(),
      friction_law_entry<HyperbolicFriction>(),
  };
  return laws;
}

/// The law called parameters.law. Throws InputError for an unknown name.
inline std::unique_ptr<FrictionLaw> make_friction_law(const FrictionParameters &parameters)
{
  std::string known;
  for (const auto &law : friction_laws())
  {
    if (parameters.law == law.name)
      return law.make(parameters);
    known += (known.empty() ? "" : ", ") + std::string(law.name);
  }
  throw InputError("There is no friction law '" + parameters.law + "'; choose one of: " + known +
                   ".");
}
} // namespace ricochet
