// SPDX-License-Identifier: LGPL-2.1-or-later
// A simulation as the watch over its outcome sees it.
#pragma once

#include "ricochet/simulation/outcome.h"
#include "ricochet/simulation/simulation.h"

namespace ricochet
{
/// The plates as they are now: each box moved by the mean displacement of its sound points (of all,
/// if none is left), those which follow elements included. Collective.
std::vector<PlatePlace> plate_places(const Simulation &simulation);

/// Of the present step and a projectile, after compute_forces(). The simulation must outlive what
/// is returned, whose plates() is collective.
Observation observe(const Simulation &simulation, std::size_t projectile = 0);

/// A watch over a projectile of a simulation at its start.
OutcomeWatch watch_of(const Simulation &simulation, std::size_t projectile = 0);
} // namespace ricochet
