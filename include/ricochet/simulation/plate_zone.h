// SPDX-License-Identifier: LGPL-2.1-or-later
// From the parameters of a plate to its peridynamic zone and the finite elements around it.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/scene/scene.h"

#include <limits>
#include <memory>

namespace ricochet
{
/// What plate_zone() decides.
struct PlateZone
{
  std::unique_ptr<Zone> zone;  // null if the plate is peridynamic throughout
  CoupledPlateOptions options; // of the elements around the zone
  double growth_ahead = std::numeric_limits<double>::infinity(); // of the projectile, along x [m]
  std::string reason;                                            // for the user
};

/// s_c from the material: given, or from the energy release rate on this stencil [-].
double critical_stretch(const MaterialParameters &material, const Stencil &stencil);

/// `plate` is one of the scene's, `box` its lattice. Throws InputError if the zone leaves nothing
/// to the elements' side or cannot be represented.
PlateZone plate_zone(const Scene &scene, const PlateParameters &plate, const Lattice::Box &box,
                     const Stencil &stencil);
} // namespace ricochet
