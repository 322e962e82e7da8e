// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest frequency of a free body of points and general hexahedra, see
// dynamics/power_iteration.h.
#pragma once

#include "ricochet/coupling/coupled_projectile_body.h"
#include "ricochet/dynamics/power_iteration.h"

namespace ricochet
{
/// `n_iterations` force evaluations about the reference configuration, the same on every rank. The
/// body is left at rest there.
FrequencyEstimate estimate_largest_frequency(CoupledProjectileBody &body, int n_iterations = 60);
} // namespace ricochet
