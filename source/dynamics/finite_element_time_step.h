// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a body of finite elements, see dynamics/power_iteration.h.
#pragma once

#include "ricochet/dynamics/power_iteration.h"
#include "ricochet/finite_elements/finite_element_body.h"

namespace ricochet
{
/// `n_iterations` force evaluations about the reference configuration (30 suffice for 1 %). The
/// body is left at rest in its reference configuration. Collective; ranks change the result by
/// rounding only.
FrequencyEstimate estimate_largest_frequency(MPI_Comm communicator, FiniteElementBody &body,
                                             int n_iterations = 30);
} // namespace ricochet
