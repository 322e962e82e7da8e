// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/simulation/sanity_check.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/units.h"

#include <sstream>

namespace ricochet
{
void check_energy(const Moment &moment)
{
  const double residual = moment.totals.relative_residual();
  if (!(residual < -runaway_share))
    return;
  std::ostringstream message;
  message << "The energy runs away: at " << moment.simulation.time() / units::us << " us (step "
          << moment.simulation.step() << ") the model holds " << 100. * (1. - residual)
          << " % of the initial energy. " << moment.simulation.describe_fastest_point()
          << " Lower 'Time/Safety factor' or 'Contact/Stiffness factor'.";
  throw RunError(message.str());
}
} // namespace ricochet
