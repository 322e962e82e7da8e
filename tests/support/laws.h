// SPDX-License-Identifier: LGPL-2.1-or-later
// The table of all bond laws, influence functions and friction laws with sample parameters: every
// invariant is looped over it. A new law is one line here; a test compares the table with the
// menus.
#pragma once

#include "ricochet/contact/friction_laws.h"
#include "ricochet/materials/bond_laws.h"
#include "ricochet/materials/influence_function.h"

#include <cctype>
#include <ostream>
#include <string>
#include <vector>

namespace ricochet::tests
{
struct BondLawSample
{
  const char *law;
  double density;       // [kg/m^3]
  double bulk_modulus;  // [Pa]
  double shear_modulus; // [Pa]
};

// PMMA at high rate, K = 5.9 GPa and mu = 2.258 GPa as in the impact studies; glass-like with mu =
// 3K/5, as the bond-based law demands.
inline const std::vector<BondLawSample> bond_law_samples{
    {"linear peridynamic solid", 1190., 5.9e9, 2.258e9},
    {"microelastic brittle", 2440., 40e9, 24e9},
};

struct FamilySample
{
  BondLawSample law;
  InfluenceFunction influence_function;
  double horizon_ratio;
};

inline std::ostream &operator<<(std::ostream &out, const FamilySample &sample)
{
  return out << sample.law.law << ", horizon ratio " << sample.horizon_ratio;
}

/// Every law with every influence function; 2.5 keeps blocks small and has a reach of 2 for all.
inline std::vector<FamilySample> family_samples()
{
  std::vector<FamilySample> samples;
  for (const auto &law : bond_law_samples)
    for (const auto &influence : influence_functions)
      samples.push_back({law, influence.function, 2.5});
  return samples;
}

/// "LinearPeridynamicSolid" from "linear peridynamic solid".
inline std::string camel_case(const std::string &words)
{
  std::string name;
  bool start = true;
  for (const char c : words)
    if (c == ' ' || c == '_' || c == '-')
      start = true;
    else
    {
      name += start ? static_cast<char>(std::toupper(c)) : c;
      start = false;
    }
  return name;
}

inline std::string name_of(const InfluenceFunction function)
{
  for (const auto &entry : influence_functions)
    if (entry.function == function)
      return entry.name;
  return "unknown";
}

inline const std::vector<FrictionParameters> friction_law_samples{
    ExponentialFriction::Parameters{0.4, 0.05, 0.01},
    ConstantFriction::Parameters{0.2},
    FlashHeatingFriction::Parameters{0.5, 0.1, 20.},
    HyperbolicFriction::Parameters{0.5, 0.1, 0.02},
};
} // namespace ricochet::tests
