// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a plate of points and elements, see dynamics/power_iteration.h.
#pragma once

#include "ricochet/coupling/coupled_plate.h"
#include "ricochet/dynamics/power_iteration.h"

namespace ricochet
{
/// `n_iterations` force evaluations about the reference configuration (30 suffice for 1 %). The
/// plate is left at rest in its reference configuration. Collective; ranks change the result by
/// rounding only.
FrequencyEstimate estimate_largest_frequency(MPI_Comm communicator, CoupledPlate &plate,
                                             int n_iterations = 30);
} // namespace ricochet
