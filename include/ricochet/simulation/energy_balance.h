// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the projectile's energy went, and the momenta. All of the full model, also with a symmetry
// plane.
#pragma once

#include "ricochet/base/vector.h"
#include "ricochet/bodies/energies.h"

namespace ricochet
{
/// Those of the plates, with the drive of the projectile, and all others [J].
struct EnergyBalance : Energies
{
  double initial         = 0.; // kinetic energy of the projectile at the start
  double projectile      = 0.; // kinetic
  double elastic         = 0.; // in its deformation
  double contact         = 0.; // in the springs between projectile and plates
  double debris          = 0.; // in the repulsion of debris
  double friction        = 0.; // heat between projectile and plates
  double debris_friction = 0.; // heat between plates and in debris

  /// What the balance does not account for [J].
  double residual() const;
};

/// All of EnergyBalance that is not in Energies, but for the initial one.
inline constexpr EnergyRow<EnergyBalance> balance_rows[] = {
    {&EnergyBalance::projectile, EnergyAccount::held, "energy projectile",
     "kinetic energy of the projectile"},
    {&EnergyBalance::elastic, EnergyAccount::held, "energy elastic",
     "stored in the deformation of the projectile"},
    {&EnergyBalance::contact, EnergyAccount::held, "energy contact",
     "stored in the penalty springs between projectile and plates"},
    {&EnergyBalance::debris, EnergyAccount::held, "energy debris",
     "stored in the repulsion of debris and between plates"},
    {&EnergyBalance::friction, EnergyAccount::given, "work friction",
     "turned into heat between projectile and plates"},
    {&EnergyBalance::debris_friction, EnergyAccount::given, "work debris friction",
     "turned into heat between plates and in debris"}};

inline double EnergyBalance::residual() const
{
  double left      = initial;
  const auto count = [&left](const double energy, const EnergyAccount account)
  { left += account == EnergyAccount::received ? energy : -energy; };
  for (const auto &row : balance_rows)
    count(this->*row.value, row.account);
  for (const auto &row : energy_rows)
    count(this->*row.value, row.account);
  return left;
}

/// With a symmetry plane only the components that it leaves free are non-zero.
struct MomentumBalance
{
  Vector3 linear;  // [kg m/s]
  Vector3 angular; // about the origin [kg m^2/s]
};
} // namespace ricochet
