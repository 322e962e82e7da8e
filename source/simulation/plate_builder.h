// SPDX-License-Identifier: LGPL-2.1-or-later
// From the parameters of a scene to the plates as bodies.
#pragma once

#include "ricochet/simulation/simulation.h"

namespace ricochet
{
/// Throws InputError if the scene lacks it.
const MaterialParameters &material_of(const Scene &scene, const PlateParameters &plate);

/// Of all plates, from top to bottom, at rest. Collective. Throws InputError if one of them cannot
/// be built.
std::vector<Plate> build_plates(MPI_Comm communicator, const Scene &scene);
} // namespace ricochet
