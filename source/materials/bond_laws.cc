// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/materials/bond_laws.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/materials/bond_law_list.h"

namespace ricochet
{
namespace
{
template <class Law>
BondLaw entry(const int index)
{
  return {Law::name,
          index,
          Law::has_dilatation,
          Law::fixes_poisson_ratio,
          &Law::bond,
          &Law::point_stiffness,
          [](const BondConstants &c, const double extension, const double theta_sum) {
            return Law::template tension<double>(c.volumetric, c.extension, extension, theta_sum);
          },
          [](const BondConstants &c, const double extension)
          { return Law::template bond_energy<double>(c.extension, extension); }};
}
} // namespace

const std::vector<BondLaw> &bond_laws()
{
  static const std::vector<BondLaw> laws = []
  {
    std::vector<BondLaw> menu;
#define RICOCHET_ENTRY(Law) menu.push_back(entry<Law>(static_cast<int>(menu.size())));
    RICOCHET_BOND_LAWS(RICOCHET_ENTRY)
#undef RICOCHET_ENTRY
    return menu;
  }();
  return laws;
}

const BondLaw &bond_law(const std::string &name)
{
  std::string known;
  for (const auto &law : bond_laws())
  {
    if (name == law.name)
      return law;
    known += (known.empty() ? "" : ", ") + std::string(law.name);
  }
  throw InputError("There is no bond model '" + name + "'; choose one of: " + known + ".");
}

std::vector<std::string> bond_law_names()
{
  std::vector<std::string> names;
  for (const auto &law : bond_laws())
    names.emplace_back(law.name);
  return names;
}
} // namespace ricochet
