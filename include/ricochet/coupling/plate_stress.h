// SPDX-License-Identifier: LGPL-2.1-or-later
// What the points of a plate feel, whoever moves them: bonds (peridynamics/point_stress.h) or
// elements (finite_elements/element_stress.h). For pictures: nothing here enters a step.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/finite_elements/element_stress.h"
#include "ricochet/peridynamics/point_stress.h"

#include <cstddef>
#include <vector>

namespace ricochet
{
/// Per entry of `indices`, which are owned points of the lattice. Free points by their bonds; those
/// that follow elements as these, `coupled` being the plate, or null if all these points are free.
/// When it may be called see PointStress::of(). Collective.
std::vector<StressState> plate_stress(const PeridynamicBody &points, CoupledPlate *coupled,
                                      const std::vector<std::ptrdiff_t> &indices);
} // namespace ricochet
