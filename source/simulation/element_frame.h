// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite elements of a plate as the output floor wants them.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/output/frame.h"

namespace ricochet
{
/// The layer of points that the section shows, from 0: next above the plane y = 0, or in it if the
/// plate has an odd number of layers.
int section_layer(const Lattice::Box &box);

/// Appends this rank's elements but those whose cell has points, which are written as such.
void add_elements(const CoupledPlate &coupled_plate, int body, FrameExtent extent,
                  ElementFrame &frame);
} // namespace ricochet
