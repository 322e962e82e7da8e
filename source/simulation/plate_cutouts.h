// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes, notches and cracks of a plate, on its lattice.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/scene/scene.h"

namespace ricochet
{
/// Which points a plate has; empty if it has all. `plate` is its number from 1, for messages.
/// Throws InputError if a hole or notch removes no point, or if all together leave none.
Lattice::Mask mask_of(const Cutouts &cutouts, const Lattice::Box &box, unsigned int plate);

/// Breaks the bonds that cross a crack. Collective. Throws InputError if a crack crosses none.
void sever_cracks(const Cutouts &cutouts, PeridynamicBody &points, unsigned int plate);
} // namespace ricochet
