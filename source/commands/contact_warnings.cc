// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_warnings.h"

#include "ricochet/base/mpi_tools.h"
#include "ricochet/base/number_text.h"
#include "ricochet/base/units.h"

#include <algorithm>
#include <iostream>

namespace ricochet
{
namespace
{
using namespace units;

/// Deeper than this the penalty spring no longer keeps bodies apart that half a spacing divides
/// [dx].
constexpr double deep = 0.5;
} // namespace

void ContactWarnings::update(const Simulation &simulation)
{
  check_depth(simulation);
  check_elements(simulation);
}

void ContactWarnings::check_depth(const Simulation &simulation)
{
  const double before = deepest_;
  deepest_            = std::max(deepest_, simulation.reaction().deepest_in_spacings);
  if (deepest_ > deep && before <= deep && rank_in(communicator_) == 0)
    std::cerr << "\nwarning: at " << with_decimals(simulation.time() / us, 2) << " us points lie "
              << with_decimals(deepest_, 2)
              << " spacings deep in the projectile, more than half a spacing: contact is too soft "
                 "for this impact. Raise 'Contact/Stiffness factor' or lower 'Time/Safety "
                 "factor'.\n";
}

void ContactWarnings::check_elements(const Simulation &simulation)
{
  if (!simulation.reaction().on_elements || on_elements_since_ >= 0.)
    return;
  on_elements_since_ = simulation.time();
  if (simulation.scene().zone.kind == ZoneKind::none) // who wants elements alone knows
    return;
  if (rank_in(communicator_) == 0)
    std::cerr << "\nwarning: at " << with_decimals(on_elements_since_ / us, 2)
              << " us the projectile, at x = "
              << with_decimals(simulation.projectile().motion().position.x() / mm, 0)
              << " mm, touches finite elements, which do not break: the peridynamic zone ends too "
                 "early, and what follows is not to be trusted. Set 'Coupling/Adaptive = true', or "
                 "enlarge the zone.\n";
}
} // namespace ricochet
