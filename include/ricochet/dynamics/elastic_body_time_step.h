// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of an elastic body of general hexahedra, see dynamics/power_iteration.h.
#pragma once

#include "ricochet/dynamics/power_iteration.h"
#include "ricochet/finite_elements/hexahedral_body.h"

namespace ricochet
{
/// `n_iterations` force evaluations about the reference configuration, the same on every rank. The
/// body is left at rest there.
FrequencyEstimate estimate_largest_frequency(HexahedralBody &body, int n_iterations = 60);
} // namespace ricochet
