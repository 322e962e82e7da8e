// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the projectile's energy went, and the momenta. All of the full model, also with a symmetry
// plane.
#pragma once

#include "ricochet/base/vector.h"

namespace ricochet
{
/// [J]
struct EnergyBalance
{
  double projectile      = 0.; // kinetic
  double elastic         = 0.; // in a deformable projectile
  double kinetic         = 0.; // of the plates
  double strain          = 0.; // in intact bonds and elements
  double hourglass       = 0.; // in the hourglass modes of one-point elements
  double conversion      = 0.; // lost where elements became points
  double contact         = 0.; // in the penalty springs between projectile and plates
  double debris          = 0.; // in the repulsion of debris
  double friction        = 0.; // turned into heat between projectile and plates
  double fracture        = 0.; // released by broken bonds
  double initial         = 0.; // kinetic energy of the projectile at the start
  double viscous         = 0.; // turned into heat by relaxation
  double absorbed        = 0.; // by edges that do not reflect
  double debris_friction = 0.; // turned into heat between plates and in debris
  double drive           = 0.; // received from what prescribes the projectile's motion

  /// What the balance does not account for [J].
  double residual() const
  {
    return initial + drive - projectile - elastic - kinetic - strain - hourglass - conversion -
           contact - debris - friction - debris_friction - fracture - viscous - absorbed;
  }
};

/// With a symmetry plane only the components that it leaves free are non-zero.
struct MomentumBalance
{
  Vector3 linear;  // [kg m/s]
  Vector3 angular; // about the origin [kg m^2/s]
};
} // namespace ricochet
