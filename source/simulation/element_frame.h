// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite elements of a plate as the output floor wants them.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/output/frame.h"

namespace ricochet
{
/// Appends this rank's elements but those whose cell has points, which are written as such.
void add_elements(const CoupledPlate &coupled_plate, int body, ElementFrame &frame);
} // namespace ricochet
