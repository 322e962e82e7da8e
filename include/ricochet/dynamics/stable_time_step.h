// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a peridynamic body, see dynamics/power_iteration.h.
#pragma once

#include "ricochet/dynamics/power_iteration.h"
#include "ricochet/peridynamics/peridynamic_body.h"

namespace ricochet
{
/// `n_iterations` force evaluations about the reference configuration (30 suffice for 1 %). The
/// body is left at rest in its reference configuration. Collective; the result does not depend on
/// the number of ranks.
FrequencyEstimate estimate_largest_frequency(MPI_Comm communicator, PeridynamicBody &body,
                                             int n_iterations = 30);
} // namespace ricochet
